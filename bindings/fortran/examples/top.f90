! SPDX-License-Identifier: Apache-2.0
! A body in free flight tumbles: its angular momentum stays, and its energy within an error of the step's square.
program top
  use gasjet
  implicit none
  type(gasjet_rigid_body_model) :: model
  type(gasjet_rigid_body_state) :: state
  type(gasjet_rigid_body_point) :: point
  real(c_double), parameter :: none(3) = 0d0
  real(c_double) :: start, momentum(3), before, dt, off(3)
  integer :: level, i

  call check(gasjet_rigid_body_defaults(model))
  model%mass = 4.5d0
  model%centre = 0d0
  model%inertia([1, 5, 9]) = [0.016d0, 0.021d0, 0.026d0]
  model%angular_velocity = [20d0, 0d0, 30d0]
  print '(a)', '    step_s   energy_off   momentum_off'
  do level = 1, size(off)
    dt = 1d-3 / 2**level
    call check(gasjet_rigid_body_start(model, state))
    call check(gasjet_rigid_body_evaluate(model, state, point))
    start = point%kinetic_energy
    momentum = state%angular_momentum
    before = 0d0
    do i = 1, nint(0.3d0 / dt)
      call check(gasjet_rigid_body_advance(model, none, dt_before=before, dt_after=dt, state=state))
      before = dt
    end do
    call check(gasjet_rigid_body_evaluate(model, state, point))
    off(level) = abs(point%kinetic_energy / start - 1d0)
    print '(f10.6, 2es12.2)', dt, off(level), norm2(state%angular_momentum - momentum) / norm2(momentum)
    if (any(state%angular_momentum /= momentum)) error stop 'the momentum has changed'
  end do
  if (any(abs(off(:2) / off(2:) - 4d0) > 0.2d0)) error stop 'the energy is not of second order'

contains

  subroutine check(status)
    integer(c_int), intent(in) :: status
    if (status /= gasjet_ok) error stop gasjet_message()
  end subroutine check
end program top
