#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Test of the programs by which scripts/charts.sh makes tables of means.csv: rows and numbers, by hand.
set -euo pipefail
charts=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../docs/make/charts" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" # a redirection by mistake would leave a file here

# makes WHAT EXPECTED AWK_ARGUMENT...: the table without its comments
makes() {
  local what=$1 expected=$2 got
  shift 2
  got=$(awk -F, "$@" | grep -v '^#')
  [[ $got == "$expected" ]] || { printf '%s: expected\n%s\ngot\n%s\n' "$what" "$expected" "$got"; exit 1; }
}

cat >means.csv <<'END'
# format: 1
point,variation,jet,quantity,mean,standard_error,runs
0,as shipped,with,final_angle_rad,0.5,0.03,32
0,as shipped,with,first_contact_s,,,0
1,as shipped,without,final_angle_rad,0.2,0.04,16
1,as shipped,without,first_contact_s,0.01,1e-4,16
2,gas [kg] = 0.08,with,final_angle_rad,0.5,0.03,15
3,gas [kg] = 0.08,without,final_angle_rad,0.2,0.04,32
4,step = 0.9,with,final_angle_rad,0.25,0,2
5,step = 0.9,without,final_angle_rad,0.5,0.1,32
END
makes jet_effects 'varied,value,quantity,mean_jet,standard_error_jet,mean_no_jet,standard_error_no_jet,runs,difference,standard_errors,decided
as shipped,-,final_angle_rad,0.5,0.03,0.2,0.04,16,0.3,6,yes
gas [kg],0.08,final_angle_rad,0.5,0.03,0.2,0.04,15,0.3,6,no
step,0.9,final_angle_rad,0.25,0,0.5,0.1,2,-0.25,2.5,no' -v study=ensemble_convergence -f "$charts/studies.awk" means.csv

printf '%s\n' '# format: 1' point,variation,scene,quantity,mean,standard_error,runs '0,contact = 0.5,no_jet,path_impulse_Ns,48.685612,0.09891,32' \
  '1,contact = 0.5,jet,path_impulse_Ns,88.5,0.7,31' >means.csv
makes impulse_limits 'varied,value,scene,quantity,mean,standard_error,runs
contact,0.5,no_jet,path_impulse_Ns,48.6856,0.0989,32
contact,0.5,jet,path_impulse_Ns,88.5,0.7,31' -v study=impulse_limits -f "$charts/studies.awk" means.csv

printf '%s\n' point,elements,seed_m,quantity,mean,standard_error,runs '0,2744,1e-4,first_contact_s,0.01462111,2.294e-05,8' >means.csv
makes first_contact_seed 'elements,seed_m,first_contact_s,standard_error_s,runs
2744,1e-4,0.0146211,2.29e-05,8' -v study=first_contact_seed -f "$charts/studies.awk" means.csv

printf '%s\n' point,fabric,refine,quantity,mean,standard_error,runs '0,isotropic 60 MPa,1,peak_pressure_Pa,101425.5,,1' \
  '0,isotropic 60 MPa,1,peak_volume_m3,0.065,,1' '0,isotropic 60 MPa,1,max(strap_force_N),400.25,,1' >means.csv
makes weave 'fabric,refine,peak_overpressure_Pa,peak_volume_m3,peak_strap_force_N
isotropic 60 MPa,1,100.5,0.065,400.25' -v study=weave -f "$charts/studies.awk" means.csv

# 2 * 0.1 / 0.5 of 16 runs is 40 times 1 %: 1600 times as many. 2 * 0.01 / 0.4 is 5 %: as many.
printf '%s\n' point,friction,jet,quantity,mean,standard_error,runs,difference,difference_standard_error,pairs \
  '0,0,with,final_angle_rad,0.5,0.1,16,0.4,0.01,16' '1,0,without,final_angle_rad,100,0.001,16,,,0' >means.csv
makes runs_needed 'friction,jet,quantity,mean,scatter,runs,runs_for_1_percent,runs_for_effect
0,with,final_angle_rad,0.5,0.4,16,25600,16
0,without,final_angle_rad,100,0.004,16,2,' -v study=runs_needed -f "$charts/studies.awk" means.csv

printf '%s\n' '# a' point,seed,steps,cpu_s 0,1,9,1 0,2,9,2 1,1,9,4 2,1,9,0.5 >timing.csv
printf '%s\n' '# b' point,variation,quantity,mean,standard_error,runs '0,step = 0.8,final_angle_rad,0.55,0.03,2' \
  '1,step = 0.2,final_angle_rad,0.5,0.04,1' '2,gas = euler 1e-4,final_angle_rad,0.45,0.03,1' >means.csv
makes coupled_work_precision 'varied,value,quantity,cpu_s,mean,standard_error,runs,error,error_standard_error
step,0.8,final_angle_rad,1.5,0.55,0.03,2,0.1,0.1
step,0.2,final_angle_rad,4,0.5,0.04,1,0,0.113
gas,euler 1e-4,final_angle_rad,0.5,0.45,0.03,1,0.1,0.1' -v study=coupled_work_precision -f "$charts/studies.awk" timing.csv means.csv

[[ $(ls) == $'means.csv\ntiming.csv' ]] || { echo "files that nobody asked for: $(ls)"; exit 1; }
for plan in none ../weave; do
  said=$("$charts/../../../scripts/charts.sh" "$plan" 2>&1) && exit 1
  [[ $said == "charts.sh: no chart '$plan'; --list tells them" ]] || { echo "of a plan that is not there: $said"; exit 1; }
done
! awk -v study=other -f "$charts/studies.awk" means.csv 2>/dev/null || { echo "a study without rows of its own was accepted"; exit 1; }
echo "charts.sh: rows and numbers as by hand"
