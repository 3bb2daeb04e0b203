# Figure 7.1 - the pin in the plate: sketch and mesh, both readings.   In: fig_7_1_*.csv   Out: fig_7_1.svg
width = 480; height = 560
load 'style.gp'
unset key; unset grid; unset border; unset xtics; unset ytics
set margins 0, 0, 0, 0
set size ratio -1
set xrange [-15.5:18.5]
set yrange [-2.3:16.9]
set style arrow 1 heads filled size 0.6,18 ls 7  # dimensions
set style arrow 2 nohead ls 7 lw 1               # their help lines
set style arrow 3 head filled size 0.7,18 ls 7   # load
set style arrow 4 nohead ls 7 lw 2 dt (5,4)      # chosen: our copy of the paper does not show it
set arrow from -13,0 to 16,0 nohead lc rgb BLACK lw 1 dt (12,3,2,3)
set label 'symmetric' at 14,-1 center
set arrow from -10,0 to -10,10 as 4
set arrow from -10,10 to 10,10 as 4
set arrow from 10,10 to 10,0 as 4
set object 3 circle at 0,0 size 5 arc [0:180] nowedge fs empty border lc rgb BLACK lw 2 dt (5,4) front
set multiplot layout 2,1
do for [reading in 't c'] {
  side = reading eq 't' ? -1 : 1
  set label 1 (side < 0 ? '(T) the load pulls' : '(C) the load presses') at 0,15.6 center font ',15'
  do for [k=0:5] {
    if (side < 0) { set arrow 20+k from 10.3,2*k+0.01 to 13.3,2*k as 3 } else { set arrow 20+k from 13.3,2*k+0.01 to 10.3,2*k as 3 }
  }
  set label 2 '25 kN/cm²' at 10.8,11.4 left
  set object 1 circle at 0.2*side,0 size 4.8 arc [0:180] fc rgb LIGHT fs solid border lc rgb BLACK behind
  set label 3 'rigid pin' at 0,3.2 center
  set object 2 polygon from 5*side,0 to 4.1*side,0.5 to 4.1*side,-0.5 to 5*side,0 front fs empty border lc rgb BLACK lw 1.5
  set label 4 'pole, held' at 5*side,-1.2 center
  if (side < 0) {
    set arrow 10 from -10,10.3 to -10,13 as 2
    set arrow 11 from 10,10.3 to 10,13 as 2
    set arrow 12 from -10,12.3 to 10,12.3 as 1
    set label 10 '20 cm' at 0,13.3 center
    set arrow 13 from -10.3,10 to -13,10 as 2
    set arrow 14 from -12.3,0 to -12.3,10 as 1
    set label 11 '10 cm' at -13.3,5 center rotate
    set arrow 15 from 0,0 to 3.54,3.54 head filled size 0.6,18 ls 7
    set label 12 '5 cm' at 1.9,1.2 left
  } else {
    do for [k=10:15] { unset arrow k }
    do for [k=10:12] { unset label k }
  }
  plot data.'/fig_7_1_'.reading.'.csv' using 'x':'y' with lines lc rgb BLUE lw 0.7 dt 1
}
unset multiplot
