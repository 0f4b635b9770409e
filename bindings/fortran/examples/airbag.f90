! SPDX-License-Identifier: Apache-2.0
! An explicit airbag of one's own: springs along the edges, an ideal gas, from a flattened start. Only the jet and its shadows are
! Gasjet's. Reads a closed surface around the origin from standard input: the numbers of nodes and triangles, then the nodes [m] and
! the triangles' corners, seen from outside against the clock.
program airbag
  use gasjet
  use, intrinsic :: ieee_arithmetic
  implicit none
  real(c_double), parameter :: dt = 5d-6, flow = 0.4d0, hot = 700d0, cp = 1039d0, r = 297d0, p_air = 101325d0
  real(c_double), parameter :: mass = 2d-4, stiffness = 4d3, damping = 100d0, outlet = 2d-3   ! kg, N/m, 1/s, m2
  real(c_double), allocatable :: x(:,:), v(:,:), f(:,:), d(:,:), s(:,:), rest(:), dp(:)
  integer(c_int32_t), allocatable :: t(:,:), a(:), b(:)
  real(c_double) :: jet_force(3), pull(3), volume, old, energy, p
  type(gasjet_jet_model) :: model
  type(gasjet_outlet_state) :: state
  type(gasjet_visibility) :: seen
  integer(c_int64_t) :: jet, n, m, k, e
  integer :: step

  read (*, *) n, m
  allocate (x(3, n), t(3, m), dp(m))
  read (*, *) x, t
  a = [t]                                                      ! the edges of all triangles: from a to b
  b = [cshift(t, 1)]
  rest = norm2(x(:, b) - x(:, a), 1)
  x(1, :) = 0.2d0 * x(1, :)                                    ! flattened: the fabric is slack
  v = 0d0 * x
  call check(gasjet_jet_defaults(model))
  model%centre = 0d0
  model%axis = [1d0, 0d0, 0d0]
  model%radius = sqrt(outlet / acos(-1d0))
  model%decay_coefficient = 0.08d0
  call check(gasjet_jet_create(model, t - 1, m, node_count=n, null_count=0_c_int64_t, attachment_count=0_c_int64_t, jet=jet))
  call check(gasjet_outlet(GASJET_SONIC_STAGNATION, outlet, flow, hot, cp, r, p_air, state))
  call measure()
  energy = p_air * volume * (cp / r - 1d0)                     ! U = p V / (gamma - 1)
  print '(a)', 'time_ms,pressure_kPa,volume_l,jet_force_N,hidden'
  do step = 0, 2000
    p = energy / (cp / r - 1d0) / volume
    call check(gasjet_jet_pressure(jet, x, n, velocity=state%velocity, density=state%density, occlusion=1, &
      displacement_bound=ieee_value(0d0, ieee_quiet_nan), overpressure=dp, overpressure_count=m, force=jet_force, counters=seen))
    if (mod(step, 10) == 0) print '(4(f0.3, ","), i0)', 1d3 * dt * step, p / 1d3, 1d3 * volume, jet_force(1), seen%hidden
    f = 0d0 * x
    do k = 1, 3 * m
      e = (k + 2) / 3
      pull = stiffness * max(1d0 - rest(k) / norm2(d(:, k)), 0d0) * d(:, k)   ! fabric never pushes
      f(:, a(k)) = f(:, a(k)) + pull + (p - p_air + dp(e)) * s(:, e) / 3d0
      f(:, b(k)) = f(:, b(k)) - pull
    end do
    v = (v + dt * f / mass) / (1d0 + dt * damping)
    x = x + dt * v
    old = volume
    call measure()
    energy = energy + flow * cp * hot * dt - p * (volume - old)
  end do
  call check(gasjet_free(jet))

contains

  subroutine measure()                                         ! edges, area vectors, volume
    d = x(:, b) - x(:, a)
    s = (cshift(d(:, 1::3), 1) * cshift(d(:, 2::3), -1) - cshift(d(:, 1::3), -1) * cshift(d(:, 2::3), 1)) / 2d0
    volume = sum(s * x(:, a(1::3))) / 3d0
  end subroutine measure

  subroutine check(status)
    integer(c_int), intent(in) :: status
    if (status /= gasjet_ok) error stop gasjet_message()
  end subroutine check
end program airbag
