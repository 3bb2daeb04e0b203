# Figure 13.3 - vertical stress and displacements, on bodies whose displacements are 200 times as large.
# In: fig_13_3*.csv   Out: fig_13_3.svg
width = 640; height = 415
load 'style.gp'
set size ratio -1
unset key; unset grid; unset border; unset tics
set xrange [0:6.85]
set yrange [-8.1:2.1]
set multiplot
set bmargin at screen 0.22
set tmargin at screen 0.99
names = 'σ_y u_x u_y'
units = 'kPa mm mm'
array levels[3]  # as in drawings.hpp
levels[1] = '-24 -18 -15 -12 -10 -8 -6 -4 -2'
levels[2] = '-0.3 -0.2 -0.1 -0.05 -0.01 0.01 0.05 0.1'
levels[3] = '-3 -2.5 -2 -1.5 -1 -0.5'
do for [k=1:3] {
  field = word('. _x _y', k)
  if (k == 1) { field = '' }
  n = words(levels[k])
  set palette maxcolors n + 1
  set cbrange [-0.5:n + 0.5]
  set cbtics scale 0 ('' 0)
  set for [i=(k == 2 ? 3 : 1):n:(k == 2 ? 5 : 2)] cbtics add (word(levels[k], i) i - 0.5)
  set cblabel word(names, k).' ['.word(units, k).']' offset 0,0.5
  set lmargin at screen 0.01 + 0.335 * (k - 1)
  set rmargin at screen 0.32 + 0.335 * (k - 1)
  set colorbox horizontal user origin 0.01 + 0.335 * (k - 1),0.17 size 0.30,0.03
  plot for [part in '.csv _footing.csv'] data.'/fig_13_3'.field.part using 'x':'y':'band' with polygons fs solid noborder fc palette, \
       for [part in '.csv _footing.csv'] data.'/fig_13_3_mesh'.part using 'x':'y' with lines lc rgb GREY lw 0.4 dt 1
}
unset multiplot
