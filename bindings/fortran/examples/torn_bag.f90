! SPDX-License-Identifier: Apache-2.0
! An explicit loop of one's own, with an outlet that moves with its module and elements that tear. The bag is a sphere of springs
! with a constant overpressure; an element with an edge longer than `tear` times its length at rest is off from then on.
program torn_bag
  use gasjet
  use, intrinsic :: ieee_arithmetic
  implicit none
  integer, parameter :: rings = 16, sectors = 24, n = 2 + (rings - 1) * sectors, m = 2 * (rings - 1) * sectors
  real(c_double), parameter :: pi = acos(-1d0), radius = 0.25d0, dt = 1d-5, p = 5d3, density = 1.5d0
  real(c_double), parameter :: mass = 1d-3, stiffness = 4d3, damping = 100d0, tear = 1.25d0   ! kg, N/m, 1/s, -
  real(c_double) :: x(3, n), v(3, n), f(3, n), d(3, 3 * m), s(3, m), rest(3 * m), dp(m), force(3), pull(3), power, work
  integer(c_int32_t) :: t(3, m), a(3 * m), b(3 * m)
  integer(c_int8_t) :: on(m)
  type(gasjet_jet_model) :: model
  type(gasjet_outlet_state) :: state
  integer(c_int64_t), parameter :: nodes = n, elements = m, none = 0
  integer(c_int64_t) :: jet
  integer :: step, k, e, torn

  call make_sphere()
  a = [t]                                                      ! the edges of all triangles: from a to b
  b = [cshift(t, 1)]
  call measure()
  rest = norm2(d, 1)
  v = 0d0
  on = 1_c_int8_t
  work = 0d0
  call check(gasjet_jet_defaults(model))
  model%centre = 0d0
  model%axis = [1d0, 0d0, 0d0]
  model%radius = 0.03d0
  model%decay_coefficient = 0.08d0
  call check(gasjet_jet_create(model, t - 1, elements, node_count=nodes, null_count=none, attachment_count=none, jet=jet))
  call check(gasjet_jet_relative_to_skin(jet, 1))              ! the skin flees from the gas
  call check(gasjet_outlet(GASJET_SONIC_STAGNATION, pi * model%radius**2, 1d0, 700d0, 1039d0, 297d0, 1d5, state))
  print '(a)', 'time_ms,outlet_y_mm,jet_force_N,jet_work_J,torn'
  do step = 0, 400
    model%centre(2) = 15d0 * dt * step                         ! the module moves at 15 m/s and turns at 100 rad/s
    model%axis = [cos(100d0 * dt * step), sin(100d0 * dt * step), 0d0]
    call check(gasjet_jet_place(jet, model%centre, model%axis))
    call check(gasjet_jet_pressure_of(jet, x, nodes, velocities=v, velocity=state%velocity, density=density, occlusion=1, &
      displacement_bound=ieee_value(0d0, ieee_quiet_nan), element_count=none, overpressure=dp, overpressure_count=elements, &
      force=force, power=power))
    if (any(on == 0 .and. dp > 0d0)) error stop 'a torn element is loaded'
    work = work + power * dt
    if (mod(step, 50) == 0) print '(4(f0.3, ","), i0)', 1d3 * dt * step, 1d3 * model%centre(2), norm2(force), work, count(on == 0)
    f = 0d0
    do k = 1, 3 * m
      e = (k + 2) / 3
      if (on(e) == 0) cycle
      pull = stiffness * max(1d0 - rest(k) / norm2(d(:, k)), 0d0) * d(:, k)   ! fabric never pushes
      f(:, a(k)) = f(:, a(k)) + pull + (p + dp(e)) * s(:, e) / 3d0
      f(:, b(k)) = f(:, b(k)) - pull
    end do
    v = (v + dt * f / mass) / (1d0 + dt * damping)
    x = x + dt * v
    call measure()
    torn = count(on == 0)
    do k = 1, 3 * m
      e = (k + 2) / 3
      if (norm2(d(:, k)) > tear * rest(k)) on(e) = 0_c_int8_t
    end do
    if (count(on == 0) > torn) call check(gasjet_jet_set_elements(jet, on, elements))
  end do
  if (torn == 0 .or. work <= 0d0) error stop 'nothing is torn, or the jet does no work'
  call check(gasjet_free(jet))

contains

  subroutine make_sphere()                                     ! rings about the x axis between two poles
    real(c_double) :: phi
    integer :: i, j
    x(:, 1) = [-radius, 0d0, 0d0]
    x(:, n) = [radius, 0d0, 0d0]
    e = 0
    do i = 1, rings - 1
      do j = 1, sectors
        phi = 2 * pi * j / sectors
        x(:, at(i, j)) = radius * [-cos(pi * i / rings), sin(pi * i / rings) * [cos(phi), sin(phi)]]
        if (i == 1) call add(1, at(1, j + 1), at(1, j))
        if (i == rings - 1) call add(n, at(i, j), at(i, j + 1))
        if (i == rings - 1) cycle
        call add(at(i, j), at(i, j + 1), at(i + 1, j))
        call add(at(i, j + 1), at(i + 1, j + 1), at(i + 1, j))
      end do
    end do
  end subroutine make_sphere

  integer function at(i, j)                                    ! node of a ring
    integer, intent(in) :: i, j
    at = 2 + (i - 1) * sectors + modulo(j - 1, sectors)
  end function at

  subroutine add(i, j, k)                                      ! a triangle, seen from outside against the clock
    integer, intent(in) :: i, j, k
    e = e + 1
    t(:, e) = [i, j, k]
  end subroutine add

  subroutine measure()                                         ! edges, area vectors
    d = x(:, b) - x(:, a)
    s = (cshift(d(:, 1::3), 1) * cshift(d(:, 2::3), -1) - cshift(d(:, 1::3), -1) * cshift(d(:, 2::3), 1)) / 2d0
  end subroutine measure

  subroutine check(status)
    integer(c_int), intent(in) :: status
    if (status /= gasjet_ok) error stop gasjet_message()
  end subroutine check
end program torn_bag
