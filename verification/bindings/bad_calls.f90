! SPDX-License-Identifier: Apache-2.0
! Calls of the Fortran module with one wrong argument each: a status, and a message that begins with its name.
! The build with sanitizers runs the program too, over its own libraries for C. argument: a case file
program bad_calls
  use gasjet
  use, intrinsic :: ieee_arithmetic
  implicit none
  integer(c_int64_t), parameter :: four = 4, none = 0, large = huge(none)
  integer(c_int64_t), parameter :: counts(5) = [-1_c_int64_t, none, 3_c_int64_t, 5_c_int64_t, large]
  real(c_double) :: x(3, 4), y(4, 3), bad(4), p(4), force(3), vectors(12), value, knots(2) = [0d0, 1d0], gap(2), &
      times(1) = [0.1d0]
  real(c_double) :: here(3) = 0.1d0
  integer(c_int32_t) :: t(3, 4), u(4, 3), wrong(3, 4)
  integer(c_int8_t) :: lit(4)
  integer(c_int64_t) :: gas, tank, skin, jet, bag, layers, body, run, table, handles(6), strides(2)
  type(gasjet_source) :: source
  type(gasjet_jet_model) :: model
  type(gasjet_fabric_model) :: fabric
  type(gasjet_gas_values) :: values
  type(gasjet_membrane_sums) :: sums
  type(gasjet_skin_contact_sums) :: touch
  type(gasjet_contact_sums) :: push
  type(gasjet_outlet_state) :: state
  type(gasjet_rigid_body_model) :: top
  type(gasjet_rigid_body_state) :: motion
  type(gasjet_rigid_body_point) :: point
  type(gasjet_rigid_body_kick) :: kick
  character(512) :: case_file
  integer :: calls = 0, i, k

  x = reshape([0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0], [3, 4])
  t = reshape([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3], [3, 4])
  y = transpose(x)
  u = transpose(t)
  bad = [ieee_value(value, ieee_quiet_nan), ieee_value(value, ieee_positive_inf), ieee_value(value, &
      ieee_negative_inf), -1d0]
  p = 1d0
  call get_command_argument(1, case_file)
  call good(gasjet_gas_create('N2=1'//c_null_char, 0d0, gas))
  call good(gasjet_tank_create(gas, 2d5, 300d0, 0.1d0, 1d5, 1d-8, tank))
  call good(gasjet_surface_create(u, four, [1_c_int64_t, four], four, null_count=none, attachment_count=none, &
                                  surface=skin))
  source%centre = here
  source%axis = [1d0, 0d0, 0d0]
  source%half_long = 0d0
  call good(gasjet_surface_visible(skin, y, four, [1_c_int64_t, four], source, candidate_count=none, &
                                   displacement_bound=bad(1), lit=lit, lit_count=four))
  if (any(lit /= 1)) error stop 'columns of Fortran are not the rows of C'
  call good(gasjet_jet_defaults(model))
  model%centre = here
  model%axis = source%axis
  model%radius = 0.1d0
  model%decay_coefficient = 0.08d0
  call good(gasjet_jet_create(model, t, four, node_count=four, null_count=none, attachment_count=none, jet=jet))
  fabric = gasjet_fabric_model(4d-4, 800d0, 3d8, 0.3d0, 1, GASJET_SAINT_VENANT_KIRCHHOFF)
  call good(gasjet_membrane_create(x, four, triangles=t, triangle_count=four, fabric=fabric, null_count=none, &
                                   fixed_count=none, membrane=bag))
  call good(gasjet_skin_contact_create(y, four, [1_c_int64_t, four], t, four, mass=p, thickness=0.1d0, &
                                       stiffness=1d5, friction=0d0, skin_contact=layers))
  call good(gasjet_skin_contact_evaluate(layers, x, four, force=vectors, force_count=12_c_int64_t, sums=touch))
  if (touch%contacts /= 0 .or. any(touch%second_nodes /= -1)) error stop 'neighbours touch'
  call good(gasjet_skin_contact_restart(layers))
  ! A disc whose axis is y: its rim of 0.1 m about a face of 0.3 m is 0.01 m below the corner of the skin at the origin.
  call good(gasjet_contact_create_body(y, four, [1_c_int64_t, four], t, four, mass=p, effective_mass=1d0, &
                                       impactor=gasjet_impactor(GASJET_DISC, [0.3d0, 0.1d0, 0d0]), &
                                       stiffness=1d5, friction=0d0, contact=body))
  vectors = 0d0
  call good(gasjet_contact_evaluate_body(body, x, four, centre=[0d0, 0d0, -0.39d0], axes=[0d0, 0d0, 1d0, 1d0, &
                                         0d0, 0d0, 0d0, 1d0, 0d0], force=vectors, force_count=12_c_int64_t, &
                                         sums=push))
  if (.not. (push%penetration > 0d0 .and. push%penetration <= 0.01d0)) error stop 'the disc is not turned'
  if (abs(sum(vectors) + sum(push%force)) > 1d-12 * abs(push%force(3))) error stop 'no reaction'
  call refused(gasjet_contact_create_body(y, four, [1_c_int64_t, four], t, four, mass=p, effective_mass=1d0, &
                                          impactor=gasjet_impactor(4_c_int64_t, [0.3d0, 0.1d0, 0d0]), &
                                          stiffness=1d5, friction=0d0, contact=run), 'impactor.shape')
  ! A mass on a rail, then a free one: the weight of 1 m/s2 for 1 s, once in half a step.
  call good(gasjet_rigid_body_defaults(top))
  call refused(gasjet_rigid_body_start(top, motion), 'body.mass')
  top%mass = 2d0
  top%centre = here
  call refused(gasjet_rigid_body_start(top, motion), 'body.inertia')
  top%motion = GASJET_ON_RAIL
  call refused(gasjet_rigid_body_start(top, motion), 'rail.direction')
  top%direction = [0d0, 0d0, -1d0]
  top%gravity = [0d0, 1d0, -1d0]
  top%springs(1)%stiffness = 8d0
  call good(gasjet_rigid_body_start(top, motion))
  call good(gasjet_rigid_body_advance(top, force=0d0 * here, dt_before=0d0, dt_after=1d0, state=motion, kick=kick))
  call good(gasjet_rigid_body_evaluate(top, motion, point))
  if (point%displacement /= 0.5d0 .or. point%own_force(3) /= 2d0 .or. kick%load_work /= 0d0) &
    error stop 'the mass does not fall along its rail'
  top%motion = GASJET_FREE_BODY
  top%inertia([1, 5, 9]) = [1d0, 2d0, 2.5d0]
  top%angular_velocity = [1d0, 0d0, 0d0]
  call good(gasjet_rigid_body_start(top, motion))
  call good(gasjet_rigid_body_advance(top, here, here, 0d0, 0.5d0, motion, kick))
  if (abs(motion%axes(6) - sin(0.5d0 * motion%angular_momentum(1))) > 1d-2) error stop 'the top does not turn'
  call good(gasjet_default_skin_stiffness(0.5d0, 4d8, 0.2d0, value))
  if (value /= 1d7) error stop 'the default stiffness is not share omega^2 rho h / 4'
  call good(gasjet_gas_create('N2=1'//c_null_char, 0d0, handles(1)))
  call good(gasjet_free(handles(1)))
  handles(2:) = [none, -1_c_int64_t, large, -large, bag]

  do i = 1, size(bad)
    call refused(gasjet_gas_create('N2=1'//c_null_char, bad(i), run), 'constant_cp_at')
    if (i < 4) call refused(gasjet_gas_evaluate(gas, bad(i), values), 'temperature')
    call refused(gasjet_orifice(bad(i), 2d5, 300d0, 297d0, 1039d0, 1d5, value), 'effective_area')
    call refused(gasjet_orifice(1d0, bad(i), 300d0, 297d0, 1039d0, 1d5, value), 'pressure')
    call refused(gasjet_fabric(bad(i), 1d0, 1d0, value), 'leak_area')
    call refused(gasjet_tank_create(gas, 2d5, 300d0, bad(i), 1d5, 1d-8, run), 'volume')
    call refused(gasjet_tank_advance(tank, bad(i), 0.1d0), 'time')
    call refused(gasjet_tank_advance(tank, 1d0, bad(i)), 'volume')
    call refused(gasjet_tank_add_vent(tank, bad(i), 1d0, 0d0), 'discharge_coefficient')
    gap = [1d0, bad(i)]
    call refused(gasjet_tank_add_inflow(tank, gas, 2_c_int64_t, knots, gap, 300d0 * [1d0, 1d0], 0d0), 'mass_flow')
    call refused(gasjet_jet_pressure(jet, x, four, velocity=bad(i), density=1d0, occlusion=1, &
                                     displacement_bound=0d0, overpressure=p, overpressure_count=four, &
                                     force=force), 'velocity')
    call refused(gasjet_skin_contact_create(x, four, triangles=t, triangle_count=four, mass=p, thickness=bad(i), &
                                            stiffness=1d5, friction=0d0, skin_contact=run), 'thickness')
    call refused(gasjet_default_skin_stiffness(0.5d0, bad(i), 0.2d0, value), 'other_frequency')
    call refused(gasjet_rigid_body_advance(top, here, here, bad(i), 0.1d0, motion, kick), 'dt_before')
    call refused(gasjet_rigid_body_advance(top, here, dt_before=0.1d0, dt_after=bad(i), state=motion), 'dt_after')
    call refused(gasjet_rigid_body_limits(top, bad(i), 1d0, value, force(1)), 'reach')
    call refused(gasjet_head_injury_criterion([0d0, 0.1d0], x, 2_c_int64_t, window=bad(i), criterion=value), 'window')
    call refused(gasjet_outlet(GASJET_EXPANDED, 1d-3, 1d0, 300d0, 1039d0, 297d0, bad(i), state), 'bag_pressure')
    call refused(gasjet_jet_expansion(jet, bad(i), 1d0, 1d0), 'area_ratio')
    call refused(gasjet_jet_expansion(jet, 1d0, bad(i), 1d0), 'reflected')
    call refused(gasjet_membrane_evaluate(bag, x, four, gamma=1.4d0, pressure=bad(i), force=vectors, &
                                          vector_count=12_c_int64_t, sums=sums), 'pressure')
    if (i == 4) cycle
    y(2, 3) = bad(i)
    call refused(gasjet_membrane_evaluate(bag, y, four, [1_c_int64_t, four], 1.4d0, 1d5, vectors, &
                                          vector_count=12_c_int64_t, sums=sums), 'nodes')
    call refused(gasjet_skin_contact_evaluate(layers, y, four, [1_c_int64_t, four], vectors, 12_c_int64_t, touch), &
                 'nodes')
    call refused(gasjet_jet_pressure(jet, y, four, [1_c_int64_t, four], 1d0, 1d0, 1, 0d0, p, four, force), 'nodes')
    source%centre(3) = bad(i)
    call refused(gasjet_surface_visible(skin, x, four, source=source, candidate_count=none, &
                                        displacement_bound=0d0, lit=lit, lit_count=four), 'source.centre')
    source%centre = here
  end do
  call refused(gasjet_jet_expansion(jet, 1d0, 1d0, 4.1d0), 'restitution')
  call refused(gasjet_jet_place(jet, here, 0d0 * here), 'axis')
  call refused(gasjet_jet_subdivide(jet, 0), 'n: ')
  call refused(gasjet_jet_set_elements(jet, lit, 3_c_int64_t), 'on: ')
  call refused(gasjet_jet_pressure_of(jet, x, four, velocity=1d0, density=1d0, occlusion=1, displacement_bound=0d0, &
                                      elements=[4], element_count=1_c_int64_t, overpressure=p, &
                                      overpressure_count=1_c_int64_t, force=force), 'elements')
  call refused(gasjet_jet_pressure_float(jet, real(x, c_float), four, velocity=1d0, density=1d0, occlusion=1, &
                                         displacement_bound=0d0, element_count=none, overpressure=p, &
                                         overpressure_count=four, force=force, power=value), 'power')
  call good(gasjet_jet_expansion(jet, 1.2d0, 0.9d0, bad(1)))
  call good(gasjet_outlet(GASJET_EXPANDED, 1d-3, 1d0, 300d0, 1039d0, 297d0, 1d5, state))
  if (state%pressure /= 1d5) error stop 'an expanded outlet is not at the pressure of the bag'
  do i = 1, size(counts)
    if (counts(i) /= four) then
      call refused(gasjet_surface_visible(skin, x, counts(i), source=source, candidate_count=none, &
                                          displacement_bound=0d0, lit=lit, lit_count=four), 'nodes')
      call refused(gasjet_surface_visible(skin, x, four, source=source, candidate_count=none, &
                                          displacement_bound=0d0, lit=lit, lit_count=counts(i)), 'lit')
      call refused(gasjet_jet_pressure(jet, x, four, velocity=1d0, density=1d0, occlusion=1, &
                                       displacement_bound=0d0, overpressure=p, overpressure_count=counts(i), &
                                       force=force), 'overpressure')
      call refused(gasjet_membrane_evaluate(bag, x, four, gamma=1.4d0, pressure=1d5, force=vectors, &
                                            vector_count=counts(i), sums=sums), 'force')
      call refused(gasjet_membrane_masses(bag, p, counts(i)), 'mass')
      call refused(gasjet_skin_contact_evaluate(layers, x, counts(i), force=vectors, force_count=12_c_int64_t, &
                                                sums=touch), 'nodes')
    end if
    if (counts(i) > 0 .and. counts(i) < large) cycle
    call refused(gasjet_surface_create(t, counts(i), node_count=four, null_count=none, attachment_count=none, &
                                       surface=run), 'triangle_count')
    call refused(gasjet_surface_create(t, four, node_count=counts(i), null_count=none, attachment_count=none, &
                                       surface=run), 'node_count')
    if (counts(i) /= 0) call refused(gasjet_exact_create('blowdown'//c_null_char, times=times, count=counts(i), &
                                                         table=table), 'count', .true.)
    do k = 1, 2
      strides = [3_c_int64_t, 1_c_int64_t]
      strides(k) = merge(counts(i), -large, counts(i) /= -1)
      call refused(gasjet_surface_create(t, four, strides, four, null_count=none, attachment_count=none, &
                                         surface=run), 'triangles')
      call refused(gasjet_surface_visible(skin, x, four, strides, source, candidate_count=none, &
                                          displacement_bound=0d0, lit=lit, lit_count=four), 'nodes')
    end do
  end do
  do i = -2, 2  ! counted from 1, and other shifts
    if (i == 0) cycle
    wrong = t + i
    call refused(gasjet_surface_create(wrong, four, node_count=four, null_count=none, attachment_count=none, &
                                       surface=run), 'triangles')
    call refused(gasjet_jet_create(model, wrong, four, node_count=four, null_count=none, attachment_count=none, &
                                   jet=run), 'triangles')
    call refused(gasjet_surface_create(t, four, node_count=four, null_elements=[4 * i], null_count=1_c_int64_t, &
                                       attachment_count=none, surface=run), 'null_elements')
  end do
  do i = 1, size(handles)
    call refused(gasjet_gas_evaluate(handles(i), 300d0, values), 'gas')
    call refused(gasjet_tank_advance(handles(i), 1d0, 1d0), 'tank')
    call refused(gasjet_skin_contact_restart(handles(i)), 'skin_contact')
    call refused(gasjet_surface_visible(handles(i), x, four, source=source, candidate_count=none, &
                                        displacement_bound=0d0, lit=lit, lit_count=four), 'surface')
    call refused(gasjet_jet_pressure(handles(i), x, four, velocity=1d0, density=1d0, occlusion=1, &
                                     displacement_bound=0d0, overpressure=p, overpressure_count=four, &
                                     force=force), 'jet')
    if (i < size(handles)) call refused(gasjet_membrane_masses(handles(i), p, four), 'membrane')
    if (i < size(handles)) call refused(gasjet_free(handles(i)), 'handle')
  end do
  call refused(gasjet_gas_create('N2=0.5'//c_null_char, 0d0, run), 'composition')
  call refused(gasjet_gas_create(c_null_char, 0d0, run), 'composition')
  call refused(gasjet_membrane_evaluate(bag, x, four, gamma=1.4d0, pressure=1d5, force=vectors, &
                                        vector_count=11_c_int64_t, sums=sums), 'force')
  call refused(gasjet_exact_create('no_form'//c_null_char, count=none, table=table), 'name', .true.)
  call refused(gasjet_exact_create('blowdown'//c_null_char, times=times, count=2000000000_c_int64_t, &
                                   table=table), 'count', .true.)
  call refused(gasjet_run('absent.toml'//c_null_char, threads=1, progress=c_null_funptr, user=c_null_ptr, &
                          run=run), 'absent.toml')
  call refused(gasjet_run(trim(case_file)//c_null_char, threads=0, progress=c_null_funptr, user=c_null_ptr, &
                          run=run), 'threads')
  call refused(gasjet_run(trim(case_file)//c_null_char, threads=1, progress=c_funloc(stop_at_once), &
                          user=c_null_ptr, run=run), 'progress')
  print '(i0, a)', calls, ' bad calls'

contains

  function stop_at_once(time, end_time, user) bind(c) result(stop_it)
    real(c_double), value :: time, end_time
    type(c_ptr), value :: user
    integer(c_int) :: stop_it
    stop_it = merge(1, 0, time <= end_time .or. c_associated(user))
  end function stop_at_once

  subroutine good(status)
    integer(c_int), intent(in) :: status
    if (status /= gasjet_ok) error stop 'refused: ' // gasjet_message()
  end subroutine good

  subroutine refused(status, argument, of_exact)
    integer(c_int), intent(in) :: status
    character(*), intent(in) :: argument
    logical, intent(in), optional :: of_exact
    character(:), allocatable :: message
    calls = calls + 1
    message = gasjet_message()
    if (present(of_exact)) message = gasjet_message(gasjet_exact_last_error())
    if (status /= gasjet_ok .and. index(message, argument) == 1) return
    print '(a, i0, 3a)', 'status ', status, ' of a bad ', argument, ': ' // message
    error stop 'a bad call went through, or its message does not name the argument'
  end subroutine refused
end program bad_calls
