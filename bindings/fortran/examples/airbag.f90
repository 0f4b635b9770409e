! SPDX-License-Identifier: Apache-2.0
! An explicit airbag of one's own: springs along the edges, an ideal gas, from a flattened start. Only the jet and its shadows are
! Gasjet's.
! usage: airbag MESH.obj HISTORY.csv     a closed surface of triangles around the origin, outward, in metres
program airbag
  use gasjet
  implicit none
  real(c_double), parameter :: dt = 5d-6, flow = 0.4d0, hot = 700d0, cp = 1039d0, r = 297d0, p_air = 101325d0
  real(c_double), parameter :: mass = 2d-4, stiffness = 4d3, damping = 100d0, outlet = 2d-3   ! kg, N/m, 1/s, m2
  real(c_double), allocatable :: x(:,:), v(:,:), f(:,:), s(:,:), dp(:), rest(:,:)
  integer(c_int32_t), allocatable :: t(:,:)
  real(c_double) :: jet_force(3), volume, old, energy, p
  type(gasjet_jet_model) :: model
  type(gasjet_outlet_state) :: state
  type(gasjet_visibility) :: seen
  integer(c_int64_t) :: jet, n, m
  integer :: i, e, history

  call read_mesh()                                             ! x (3, n), t (3, m) with numbers from 1
  allocate (v(3, n), f(3, n), s(3, m), dp(m), rest(3, m))
  v = 0d0
  do e = 1, int(m)
    rest(:, e) = [(norm2(x(:, t(mod(i, 3) + 1, e)) - x(:, t(i, e))), i = 1, 3)]
  end do
  x(1, :) = 0.2d0 * x(1, :)                                    ! flattened: the fabric is slack
  call check(gasjet_jet_defaults(model))
  model%centre = 0d0
  model%axis = [1d0, 0d0, 0d0]
  model%radius = sqrt(outlet / acos(-1d0))
  model%decay_coefficient = 0.08d0
  call check(gasjet_jet_create(model, t - 1, m, node_count=n, null_count=0_c_int64_t, &
                               attachment_count=0_c_int64_t, jet=jet))
  call check(gasjet_outlet(GASJET_SONIC_STAGNATION, outlet, flow, hot, cp, r, p_air, state))
  call surface()
  energy = p_air * volume * (cp / r - 1d0)                     ! U = p V / (gamma - 1)
  open (newunit=history, file=file_of(2), action='write')
  write (history, '(a)') 'time_ms,pressure_kPa,volume_l,jet_force_N,hidden'
  do i = 1, 2000
    p = energy / (cp / r - 1d0) / volume
    call check(gasjet_jet_pressure(jet, x, n, velocity=state%velocity, density=state%density, occlusion=1, &
      displacement_bound=ieee_nan(), overpressure=dp, overpressure_count=m, force=jet_force, counters=seen))
    ! Reflected straight back the jet pushes with twice its momentum flux; a curved front sends part of it aside.
    if (i == 1 .and. abs(jet_force(1) / (flow * state%velocity) - 1.5d0) > 0.5d0) error stop 'jet force'
    f = 0d0
    do e = 1, int(m)
      call add_springs(e)
      f(:, t(:, e)) = f(:, t(:, e)) + spread((p - p_air + dp(e)) * s(:, e) / 3d0, 2, 3)
    end do
    v = (v + dt * f / mass) / (1d0 + dt * damping)
    x = x + dt * v
    old = volume
    call surface()
    energy = energy + flow * cp * hot * dt - p * (volume - old)
    if (mod(i, 10) == 0) write (history, '(4(g0, ","), g0)') 1d3 * i * dt, p / 1d3, 1d3 * volume, jet_force(1), seen%hidden
    if (i == 1 .or. mod(i, 500) == 0) print '(f7.2, a, f9.0, a, f7.4, a, f7.1, a, i0, a)', 1d3 * i * dt, ' ms', p, ' Pa', volume, &
      ' m3, jet', jet_force(1), ' N, ', seen%hidden, ' hidden'
  end do
  close (history)
  call check(gasjet_free(jet))

contains

  function file_of(i) result(name)
    integer, intent(in) :: i
    character(200) :: name
    call get_command_argument(i, name)
  end function file_of

  subroutine surface()                                         ! area vectors and volume
    do e = 1, int(m)
      s(:, e) = cross(x(:, t(2, e)) - x(:, t(1, e)), x(:, t(3, e)) - x(:, t(1, e))) / 2d0
    end do
    volume = sum(s * x(:, t(1, :))) / 3d0
  end subroutine surface

  subroutine add_springs(e)
    integer, intent(in) :: e
    integer :: k, a, b
    real(c_double) :: d(3), pull(3)
    do k = 1, 3
      a = t(k, e)
      b = t(mod(k, 3) + 1, e)
      d = x(:, b) - x(:, a)
      pull = stiffness * max(norm2(d) / rest(k, e) - 1d0, 0d0) * d / norm2(d) * rest(k, e)   ! fabric never pushes
      f(:, a) = f(:, a) + pull
      f(:, b) = f(:, b) - pull
    end do
  end subroutine add_springs

  function cross(a, b) result(c)
    real(c_double), intent(in) :: a(3), b(3)
    real(c_double) :: c(3)
    c = [a(2) * b(3) - a(3) * b(2), a(3) * b(1) - a(1) * b(3), a(1) * b(2) - a(2) * b(1)]
  end function cross

  function ieee_nan() result(nan)                              ! no node's motion is known
    use, intrinsic :: ieee_arithmetic
    real(c_double) :: nan
    nan = ieee_value(nan, ieee_quiet_nan)
  end function ieee_nan

  subroutine read_mesh()
    character(200) :: line
    integer :: unit, io, pass
    do pass = 1, 2
      open (newunit=unit, file=file_of(1), status='old')
      n = 0
      m = 0
      do
        read (unit, '(a)', iostat=io) line
        if (io /= 0) exit
        if (line(1:2) == 'v ') then
          n = n + 1
          if (pass == 2) read (line(3:), *) x(:, n)
        else if (line(1:2) == 'f ') then
          m = m + 1
          if (pass == 2) read (line(3:), *) t(:, m)
        end if
      end do
      close (unit)
      if (pass == 1) allocate (x(3, n), t(3, m))
    end do
  end subroutine read_mesh

  subroutine check(status)
    integer(c_int), intent(in) :: status
    if (status /= gasjet_ok) then
      print '(a)', gasjet_message()
      error stop
    end if
  end subroutine check
end program airbag
