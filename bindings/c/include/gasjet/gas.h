// SPDX-License-Identifier: Apache-2.0
/* Thermodynamics, outflow laws, and a tank: libgas. For the tags (G.n) see docs/theory/gas.md. */
#ifndef GASJET_GAS_H
#define GASJET_GAS_H

#include <gasjet/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Properties of 1 kg of a gas at one temperature. */
typedef struct gasjet_gas_values {
  double gas_constant;    /* [J/(kg K)] */
  double cp;              /* [J/(kg K)] (G.1) */
  double cv;              /* [J/(kg K)] */
  double gamma;           /* [-] cp/cv */
  double enthalpy;        /* [J/kg] (G.2) */
  double internal_energy; /* [J/kg] (G.4) */
  double speed_of_sound;  /* [m/s] */
} gasjet_gas_values;

/* A mixture by mole: "N2=0.78, O2=0.22", fractions above 0 with sum 1 to 1e-9. Species: N2 O2 Ar He H2 CO
 * CO2 H2O NO N2O NH3 CH4. constant_cp_at [K]: 200 to 6000 makes cp constant, with its value at that
 * temperature; 0: cp(T) by NASA-7. */
GASJET_API int gasjet_gas_create(const char* composition, double constant_cp_at, gasjet_handle* gas);

/* A gas of constant cp [J/(kg K)] > gas_constant [J/(kg K)] > 0; h = cp T, without an offset. */
GASJET_API int gasjet_gas_create_ideal(double gas_constant, double cp, gasjet_handle* gas);

/* Properties at temperature [K]. GASJET_DOMAIN outside the range of the gas. */
GASJET_API int gasjet_gas_evaluate(gasjet_handle gas, double temperature, gasjet_gas_values* values);

/* Temperature [K] from the internal energy [J/kg]. GASJET_DOMAIN outside the range of the gas. */
GASJET_API int gasjet_gas_temperature(gasjet_handle gas, double internal_energy, double* temperature);

/* Entropy [J/(kg K)] at temperature [K] and pressure [Pa] > 0 (G.15). */
GASJET_API int gasjet_gas_entropy(gasjet_handle gas, double temperature, double pressure, double* entropy);

/* Pressure ratio at which a hole chokes (G.5), gamma > 1. */
GASJET_API int gasjet_critical_pressure_ratio(double gamma, double* ratio);

/* Mass flow [kg/s] of a hole (G.6): effective_area = Cd A [m2] >= 0, pressure [Pa] >= 0, temperature [K] >
 * 0, gas_constant and cp [J/(kg K)] with cp > gas_constant > 0, ambient_pressure [Pa] >= 0. 0 unless the
 * pressure is above ambient_pressure. */
GASJET_API int gasjet_orifice(double effective_area, double pressure, double temperature, double gas_constant,
                              double cp, double ambient_pressure, double* mass_flow);

/* Mass flow [kg/s] of porous fabric (G.7): leak_area = sum eta^2 A [m2] >= 0, density [kg/m3] >= 0,
 * overpressure [Pa]; 0 unless the overpressure is above 0. */
GASJET_API int gasjet_fabric(double leak_area, double density, double overpressure, double* mass_flow);

/* State of a tank. Without gas everything is 0 except time, volume and the last temperature. */
typedef struct gasjet_tank_state {
  double time;            /* [s] */
  double pressure;        /* [Pa] */
  double temperature;     /* [K] */
  double volume;          /* [m3] */
  double mass;            /* [kg] */
  double internal_energy; /* [J] */
  double density;         /* [kg/m3] */
  double gamma;           /* [-] */
  double cp;              /* [J/(kg K)] */
  double gas_constant;    /* [J/(kg K)] */
  double inflow;          /* [kg/s] */
  double vent_outflow;    /* [kg/s] */
  double fabric_outflow;  /* [kg/s] */
  double backflow;        /* [kg/s] of gas outside, in through the vents */
  double heat_loss;       /* [W] through the walls */
} gasjet_tank_state;

/* Amounts that crossed a tank's border since the start, and residuals of the balances. */
typedef struct gasjet_tank_balance {
  double mass_in;         /* [kg] of inflows */
  double enthalpy_in;     /* [J] */
  double backflow_mass;   /* [kg] in through vents */
  double backflow_energy; /* [J] its enthalpy */
  double vent_mass_out;   /* [kg] */
  double fabric_mass_out; /* [kg] */
  double enthalpy_out;    /* [J] */
  double work;            /* [J] int p dV */
  double heat;            /* [J] lost through the walls */
  double mass_residual;   /* [kg] mass now - at the start - in + out */
  double energy_residual; /* [J] internal energy now - at the start - in + out + work + heat */
  int64_t substeps;       /* sub-steps of the integrator */
} gasjet_tank_balance;

/* A volume of gas at uniform pressure [Pa] >= 0 (0: evacuated), temperature [K] and volume [m3] > 0 at
 * time 0, with ambient_pressure [Pa] >= 0 outside. tolerance [-], 1e-13 to 1e-2, bounds the local error of
 * a step. */
GASJET_API int gasjet_tank_create(gasjet_handle gas, double pressure, double temperature, double volume,
                                  double ambient_pressure, double tolerance, gasjet_handle* tank);

/* Parts of a tank. Add them before its first gasjet_tank_advance.
 * Inflow: count >= 2 knots with mass_flow [kg/s] >= 0 and temperature [K] at rising times [s] since
 * start_time [s]; linear between knots, no flow outside them. The gas handle may be freed afterwards. */
GASJET_API int gasjet_tank_add_inflow(gasjet_handle tank, gasjet_handle gas, int64_t count,
                                      const double time[], const double mass_flow[],
                                      const double temperature[], double start_time);

/* Vent of area [m2] >= 0 and discharge_coefficient 0 to 1. It opens for ever when the overpressure reaches
 * opens_at [Pa]; 0: always open. */
GASJET_API int gasjet_tank_add_vent(gasjet_handle tank, double discharge_coefficient, double area,
                                    double opens_at);

/* Porous fabric (G.7) of leak_area = sum eta^2 A [m2] >= 0. Areas of several calls add up. */
GASJET_API int gasjet_tank_add_fabric(gasjet_handle tank, double leak_area);

/* Vent `vent`, from 0 as they were added, lets gas of temperature [K] in while the pressure is below the
 * ambient one (G.9). All such vents let in the gas of the last call. The handle may be freed afterwards. */
GASJET_API int gasjet_tank_add_backflow(gasjet_handle tank, int64_t vent, gasjet_handle gas,
                                        double temperature);

/* What may change at any time; it counts from the tank's time on.
 * Area [m2] >= 0 of a vent, which stays closed until opens_at is reached. */
GASJET_API int gasjet_tank_set_vent(gasjet_handle tank, int64_t vent, double area);

/* Heat lost through the walls, conductance (T - outside_temperature) [W] (G.11): conductance [W/K] >= 0,
 * outside_temperature [K] > 0. */
GASJET_API int gasjet_tank_set_heat_loss(gasjet_handle tank, double conductance, double outside_temperature);

/* Advances to `time` [s], later than now. The volume changes linearly to `volume` [m3] > 0. */
GASJET_API int gasjet_tank_advance(gasjet_handle tank, double time, double volume);

GASJET_API int gasjet_tank_read(gasjet_handle tank, gasjet_tank_state* state);

/* Names of the species in a tank, one a line; sizes as in gasjet_run_summary. */
GASJET_API int gasjet_tank_species(gasjet_handle tank, char GASJET_OR_NULL text[], int64_t size,
                                   int64_t* needed);

/* Mass [kg] and amount [mol] of each of these species. */
GASJET_API int gasjet_tank_masses(gasjet_handle tank, double mass[], double amount[], int64_t species_count);

GASJET_API int gasjet_tank_read_balance(gasjet_handle tank, gasjet_tank_balance* balance);

#ifdef __cplusplus
}
#endif
#endif
