// SPDX-License-Identifier: Apache-2.0
#include "other_cards.hpp"

#include <array>

namespace driver::imported {
namespace {

struct Kind {
  std::string_view begins;
  OtherCard outcome;
};

constexpr OtherCard solver_card{Mapping::left_out, "of the other program's own solution"};
constexpr OtherCard output_card{Mapping::left_out, "of the other program's own results"};
constexpr OtherCard text_card{Mapping::left_out, "no numbers of the bag"};
constexpr OtherCard others_card{Mapping::left_out, "not of the bag: other parts are not mapped"};
constexpr OtherCard contact_card{Mapping::none,
                                 "contact with other parts is not mapped: the bag does not touch them"};
constexpr OtherCard layers_card{Mapping::none,
                                "the bag may touch itself or other parts by this contact, which is not "
                                "mapped: layers pass through each other; set "
                                "[membrane.self_contact] by hand"};
constexpr OtherCard tied_card{Mapping::none,
                              "ties of nodes to other parts are not mapped; allowed: common nodes", true};
constexpr OtherCard occupant_card{Mapping::none, "occupants are not mapped"};
constexpr OtherCard set_card{Mapping::left_out, "a set that nothing of the bag uses"};
constexpr OtherCard unused_card{Mapping::left_out, "nothing of the bag uses it"};
constexpr OtherCard unknown_card{Mapping::left_out,
                                 "not known to this program; check that the bag does without it"};
constexpr OtherCard moves_card{Mapping::none,
                               "moves the deck's nodes, which is not mapped; allowed: a deck with nodes "
                               "where they start",
                               true};
constexpr OtherCard stress_card{Mapping::none,
                                "initial stress is not mapped: the fabric's stress follows from its "
                                "reference geometry"};
constexpr OtherCard forces_card{Mapping::none, "loads on other parts or nodes are not mapped"};

constexpr std::array lsdyna_kinds{
    Kind{"*KEYWORD", text_card},
    Kind{"*TITLE", text_card},
    Kind{"*COMMENT", text_card},
    Kind{"*PARAMETER", {Mapping::exact, "values of fields"}},
    Kind{"*INCLUDE_TRANSFORM", moves_card},
    Kind{"*INCLUDE_", {Mapping::none, "this kind of include is not read; allowed: *INCLUDE", true}},
    Kind{"*INCLUDE", {Mapping::exact, "the file's cards"}},
    Kind{"*NODE_TRANSFORM", moves_card},
    Kind{"*PART_MOVE", moves_card},
    Kind{"*DATABASE", output_card},
    Kind{"*CONTROL_ADAPTIVE", {Mapping::none, "adaptivity is not mapped: the mesh stays as it is"}},
    Kind{"*CONTROL", solver_card},
    Kind{"*HOURGLASS", solver_card},
    Kind{"*INTERFACE", output_card},
    Kind{"*SENSOR", {Mapping::none, "sensors are not mapped: what they switch acts from the start"}},
    Kind{"*AIRBAG_INTERACTION", {Mapping::none, "chambers that exchange gas are not mapped", true}},
    Kind{"*CONTACT_TIED", tied_card},
    Kind{"*CONTACT_AUTOMATIC_SINGLE_SURFACE", layers_card},
    Kind{"*CONTACT_SINGLE_SURFACE", layers_card},
    Kind{"*CONTACT_AUTOMATIC_GENERAL", layers_card},
    Kind{"*CONTACT", contact_card},
    Kind{"*SET_", set_card},
    Kind{"*DEFINE", unused_card},
    Kind{"*BOUNDARY", forces_card},
    Kind{"*LOAD", forces_card},
    Kind{"*INITIAL_STRESS", stress_card},
    Kind{"*INITIAL_VELOCITY", {Mapping::none, "initial velocities are not mapped: the bag starts at rest"}},
    Kind{"*INITIAL", forces_card},
    Kind{"*RIGIDWALL", others_card},
    Kind{"*CONSTRAINED_ADAPTIVITY", unused_card},
    Kind{"*CONSTRAINED", others_card},
    Kind{"*ELEMENT", others_card},
    Kind{"*PART", others_card},
    Kind{"*SECTION", others_card},
    Kind{"*MAT_", others_card},
    Kind{"*EOS", others_card},
    Kind{"*NODE", others_card},
    Kind{"*DAMPING", others_card},
    Kind{"*COMPONENT", occupant_card},
};

constexpr std::array radioss_kinds{
    Kind{"/BEGIN", text_card},
    Kind{"/TITLE", text_card},
    Kind{"/END", text_card},
    Kind{"#INCLUDE", {Mapping::exact, "the file's lines"}},
    Kind{"/PARAMETER", {Mapping::exact, "values of fields"}},
    Kind{"/TRANSFORM", moves_card},
    Kind{"//SUBMODEL", moves_card},
    Kind{"/TH", output_card},
    Kind{"/ANIM", output_card},
    Kind{"/STATE", output_card},
    Kind{"/SPMD", solver_card},
    Kind{"/IOFLAG", solver_card},
    Kind{"/ANALY", solver_card},
    Kind{"/DEF_", solver_card},
    Kind{"/MEMORY", solver_card},
    Kind{"/RANDOM", {Mapping::left_out, "random noise on the nodes"}},
    Kind{"/ADMESH", {Mapping::none, "adaptivity is not mapped: the mesh stays as it is"}},
    Kind{"/MONVOL", {Mapping::none, "a volume of a bag that is refused"}},
    Kind{"/INTER/TYPE2/", tied_card},
    Kind{"/INTER/TYPE7/", layers_card},
    Kind{"/INTER/TYPE11/", layers_card},
    Kind{"/INTER", contact_card},
    Kind{"/GRNOD", set_card},
    Kind{"/GRSHEL", set_card},
    Kind{"/GRSH3N", set_card},
    Kind{"/GRPART", set_card},
    Kind{"/SURF", set_card},
    Kind{"/LINE", set_card},
    Kind{"/SET", set_card},
    Kind{"/SUBSET", set_card},
    Kind{"/SENSOR", unused_card},
    Kind{"/FUNCT", unused_card},
    Kind{"/MAT", others_card},
    Kind{"/PROP", others_card},
    Kind{"/PART", others_card},
    Kind{"/LEAK", others_card},
    Kind{"/FAIL", {Mapping::none, "failure of fabric is not mapped"}},
    Kind{"/INISHE", stress_card},
    Kind{"/INISH3", stress_card},
    Kind{"/INIVEL", {Mapping::none, "initial velocities are not mapped: the bag starts at rest"}},
    Kind{"/SHELL", others_card},
    Kind{"/SH3N", others_card},
    Kind{"/BRICK", others_card},
    Kind{"/SPRING", others_card},
    Kind{"/TRUSS", others_card},
    Kind{"/BEAM", others_card},
    Kind{"/RBODY", others_card},
    Kind{"/RWALL", others_card},
    Kind{"/NODE", others_card},
    Kind{"/SHFRA", unused_card},
    Kind{"/SKEW", unused_card},
    Kind{"/FRAME", unused_card},
    Kind{"/BCS", forces_card},
    Kind{"/IMP", forces_card},
    Kind{"/CLOAD", forces_card},
    Kind{"/PLOAD", forces_card},
    Kind{"/GRAV", forces_card},
    Kind{"/DAMP", others_card},
    Kind{"/XREF", others_card},
    Kind{"/REFSTA", {Mapping::exact, "the file's nodes"}},
    Kind{"/UNIT",
         {Mapping::none, "units of single cards are not mapped; allowed: one system of units", true}},
};

}  // namespace

OtherCard other_card(std::string_view keyword, DeckFormat program) {
  const auto find = [&](const auto& table) {
    for (const Kind& kind : table)
      if (keyword.starts_with(kind.begins)) return kind.outcome;
    return unknown_card;
  };
  return program == DeckFormat::lsdyna ? find(lsdyna_kinds) : find(radioss_kinds);
}

}  // namespace driver::imported
