# Figure 15.2 - shear below the cylinder on the way there and back.
# In: fig_15_2.csv, fig_15_2_exact.csv   Out: fig_15_2.svg
width = 640; height = 480
load 'style.gp'
set multiplot
set xrange [-1:1]; set yrange [-1.15:1.15]
set xtics 0.5; set ytics 0.5
set key off
set samples 181
file = data.'/fig_15_2.csv'; exact = data.'/fig_15_2_exact.csv'
stats exact using 'x' nooutput
b = STATS_max
do for [i=0:3] {
  left = 0.13 + 0.44*(i%2); bottom = i < 2 ? 0.59 : 0.16
  set lmargin at screen left; set rmargin at screen left + 0.40
  set bmargin at screen bottom; set tmargin at screen bottom + 0.34
  if (i < 2) { unset xlabel; set format x '' } else { set xlabel '{/:Italic x} [mm]' offset 0,0.5; set format x '%g' }
  if (i%2) { unset ylabel; set format y '' } else { set ylabel 'shear / {/:Italic μq}_0' offset 1.5,0; set format y '%g' }
  set title i == 0 ? 'growing: {/:Italic Q} = 0.6 {/:Italic μP}' : i == 1 ? 'back at {/:Italic Q} = 0' : i == 2 ? 'back at {/:Italic Q} = −0.3 {/:Italic μP}' : 'back at {/:Italic Q} = −0.6 {/:Italic μP}' offset 0,-0.6
  plot '+' using (b*cos($1*pi)):(sin($1*pi)) with lines lw 1.2 lc rgb GREY dt (6,4), \
       exact every :::i::i using 'x':'shear' with lines ls 7, \
       file every :::i::i using 'x':'shear' with points pt 7 ps 0.6 lc rgb RED
}
unset multiplot
