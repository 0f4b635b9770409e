/* SPDX-License-Identifier: Apache-2.0
 * usage: headform     a guided headform meets a stop; displacement, acceleration and head injury criterion
 * beside the closed forms of a half sine */
#include <gasjet.h>
#include <math.h>
#include <stdio.h>

enum { STEPS = 2000 };

static void check(int status) {
  if (status != GASJET_OK) fprintf(stderr, "%s\n", gasjet_last_error());
}

int main(void) {
  const double mass = 4.54, speed = 6.0, stiffness = 6e4, g = 9.80665, pi = 3.14159265358979;
  const double duration = pi * sqrt(mass / stiffness), dt = duration / STEPS, none[3] = {0.0, 0.0, 0.0};
  static double time[STEPS], acceleration[STEPS][3];
  double deepest = 0.0, criterion = 0.0, before = 0.0;
  gasjet_rigid_body_model model;
  gasjet_rigid_body_state state;
  int i;

  check(gasjet_rigid_body_defaults(&model));
  model.motion = GASJET_ON_RAIL;
  model.mass = mass;
  model.direction[2] = -1.0;
  model.velocity[2] = -speed;
  for (i = 0; i < 3; ++i) model.centre[i] = 0.0;
  model.springs[0].stiffness = stiffness; /* a stop that it touches at the start */
  model.springs[0].one_sided = 1;
  check(gasjet_rigid_body_start(&model, &state));
  for (i = 0; i < STEPS; ++i, before = dt) {
    gasjet_rigid_body_point point;
    gasjet_rigid_body_kick kick;
    check(gasjet_rigid_body_evaluate(&model, &state, &point));
    check(gasjet_rigid_body_advance(&model, none, NULL, before, dt, &state, &kick));
    if (point.displacement > deepest) deepest = point.displacement;
    time[i] = i * dt;
    acceleration[i][2] = kick.acceleration[2];
  }
  check(gasjet_head_injury_criterion(time, acceleration[0], STEPS, NULL, 0.036, &criterion));
  printf("displacement %.3f mm, closed form %.3f mm\n", 1e3 * deepest, 1e3 * speed * sqrt(mass / stiffness));
  printf("acceleration %.2f g, closed form %.2f g\n", acceleration[STEPS / 2][2] / g,
         speed * sqrt(stiffness / mass) / g);
  /* 0.414646 times duration and amplitude^2.5 of a half sine, over 0.67 of its duration */
  printf("head injury criterion %.1f, closed form %.1f\n", criterion,
         0.414646 * duration * pow(speed * sqrt(stiffness / mass) / g, 2.5));
  return 0;
}
