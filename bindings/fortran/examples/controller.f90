! SPDX-License-Identifier: Apache-2.0
! A bag whose vent a controller moves: it opens in proportion to the overpressure above a limit.
! usage: controller CASE.toml, of a bag with a vent
program controller
  use gasjet
  implicit none
  real(c_double), parameter :: limit = 103000d0, full = 106000d0, largest = 0.1d0   ! Pa, Pa, m2
  integer(c_int64_t) :: sim, steps, nodes, columns, stride
  integer(c_int) :: ended
  type(gasjet_tank_state) :: gas
  type(c_ptr) :: address
  real(c_double), pointer :: x(:, :)
  real(c_double) :: time, area, drift, highest
  character(len=1024) :: file

  call get_command_argument(1, file)
  call check(gasjet_sim_create(trim(file)//c_null_char, threads=1_c_int, sim=sim))
  call check(gasjet_sim_view(sim, GASJET_SIM_POSITION, address, nodes, columns, stride))
  call c_f_pointer(address, x, [stride, nodes])               ! x(1:3, node), which follows the steps
  highest = 0d0
  ended = 0
  print '(a)', '  time_ms  pressure_kPa  vent_cm2  farthest_node_mm'
  do while (ended == 0)
    call check(gasjet_sim_gas(sim, gas))
    highest = max(highest, gas%pressure)
    area = largest * min(1d0, max(0d0, (gas%pressure - limit) / (full - limit)))
    call check(gasjet_sim_set_vent(sim, 0_c_int64_t, area))
    call check(gasjet_sim_step(sim, 1_c_int64_t))
    call check(gasjet_sim_time(sim, time, steps, ended))
    if (mod(steps, 100_c_int64_t) == 0) &
      print '(f9.2, f14.3, f10.2, f18.1)', 1d3 * time, gas%pressure / 1d3, 1d4 * area, 1d3 * maxval(norm2(x(1:3, :), 1))
  end do
  call check(gasjet_sim_finish(sim))
  call check(gasjet_sim_drift(sim, drift))
  if (highest > full) error stop 'the controller let the pressure rise'
  if (drift > 2d-3) error stop 'the energy drifts'
  call check(gasjet_free(sim))

contains

  subroutine check(status)
    integer(c_int), intent(in) :: status
    if (status /= gasjet_ok) error stop gasjet_message()
  end subroutine check
end program controller
