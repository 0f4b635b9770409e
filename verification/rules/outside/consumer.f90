! SPDX-License-Identifier: Apache-2.0
! A ball of four triangles seen from its middle, and a tank that empties through a hole beside its closed form.
program consumer
  use gasjet
  implicit none
  integer(c_int64_t) :: gas, vessel, table, skin
  type(gasjet_tank_state) :: state
  type(gasjet_source) :: source
  type(c_ptr) :: column
  real(c_double), pointer :: exact(:)
  real(c_double) :: times(1) = [0.1d0], nodes(3, 4), off
  integer(c_int32_t) :: triangles(3, 4)
  integer(c_int8_t) :: lit(4)

  nodes = reshape([0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0], [3, 4])
  triangles = reshape([1, 3, 2, 1, 2, 4, 1, 4, 3, 2, 3, 4], [3, 4])
  source%centre = 0.1d0
  source%axis = [1d0, 0d0, 0d0]
  source%long_direction = [0d0, 1d0, 0d0]
  source%half_long = 0d0
  call check(gasjet_surface_create(triangles - 1, 4_c_int64_t, node_count=4_c_int64_t, null_count=0_c_int64_t, &
                                   attachment_count=0_c_int64_t, surface=skin))
  call check(gasjet_surface_visible(skin, nodes, 4_c_int64_t, source=source, candidate_count=0_c_int64_t, displacement_bound=0d0, &
                                    lit=lit, lit_count=4_c_int64_t))
  if (any(lit /= 1)) error stop 'Fortran: hidden elements in a tetrahedron'
  call check(gasjet_gas_create_ideal(296.8d0, 1038.8d0, gas))
  call check(gasjet_tank_create(gas, 5d5, 600d0, 0.06d0, 101325d0, 1d-10, vessel))
  call check(gasjet_tank_add_vent(vessel, 1d0, 1d-3, 0d0))
  call check(gasjet_tank_advance(vessel, times(1), 0.06d0))
  call check(gasjet_tank_read(vessel, state))
  call check(gasjet_exact_create('blowdown'//c_null_char, times=times, count=1_c_int64_t, table=table))
  call check(gasjet_exact_column(table, 1_c_int64_t, column))
  call c_f_pointer(column, exact, [1])
  off = abs(state%pressure / exact(1) - 1d0)
  if (off > 1d-8) error stop 'Fortran: the tank differs from its closed form'
  print '(a, es7.0, a)', 'Fortran: off by', off, ': holds'

contains

  subroutine check(status)
    integer(c_int), intent(in) :: status
    if (status /= gasjet_ok) then
      print '(a)', gasjet_message() // gasjet_message(gasjet_exact_last_error())
      error stop
    end if
  end subroutine check
end program consumer
