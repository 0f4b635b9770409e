! SPDX-License-Identifier: Apache-2.0
! A tank of nitrogen empties through a hole, and the closed form beside it.
program tank
  use gasjet
  implicit none
  integer(c_int64_t) :: gas, vessel, columns, rows
  integer(c_int64_t) :: table
  type(gasjet_tank_state) :: state
  type(c_ptr) :: column
  real(c_double), pointer :: exact(:)
  real(c_double) :: times(3) = [0.1d0, 0.2d0, 0.3d0]
  integer :: i

  call check(gasjet_gas_create_ideal(296.8d0, 1038.8d0, gas))
  call check(gasjet_tank_create(gas, 5d5, 600d0, 0.06d0, 101325d0, 1d-10, vessel))
  call check(gasjet_tank_add_vent(vessel, 1d0, 1d-3, 0d0))
  call check(gasjet_exact_create('blowdown'//c_null_char, times=times, count=3_c_int64_t, table=table))
  call check(gasjet_exact_size(table, columns, rows))
  call check(gasjet_exact_column(table, 1_c_int64_t, column))   ! after the time: the pressure
  call c_f_pointer(column, exact, [rows])
  print '(a)', '  time_s   pressure_Pa   closed_form_Pa'
  do i = 1, size(times)
    call check(gasjet_tank_advance(vessel, times(i), 0.06d0))
    call check(gasjet_tank_read(vessel, state))
    print '(f8.3, 2f16.6)', times(i), state%pressure, exact(i)
    if (abs(state%pressure - exact(i)) > 1d-8 * exact(i)) error stop 'the tank is off its closed form'
  end do
  call check(gasjet_free(vessel))
  call check(gasjet_free(gas))
  call check(gasjet_exact_free(table))

contains

  subroutine check(status)
    integer(c_int), intent(in) :: status
    if (status /= gasjet_ok) then
      print '(a)', gasjet_message() // gasjet_message(gasjet_exact_last_error())
      error stop
    end if
  end subroutine check
end program tank
