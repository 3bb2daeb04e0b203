# Figure 12.3 - displacements across and along the load, on bodies drawn whose displacements are 50 times as large.
# In: fig_12_3_x*.csv, fig_12_3_y*.csv, fig_12_3_mesh*.csv   Out: fig_12_3.svg
width = 640; height = 460
load 'style.gp'
set size ratio -1
unset key; unset grid; unset border; unset tics
set xrange [0:56]
set yrange [-14:104]
set multiplot
set bmargin at screen 0.03
set tmargin at screen 0.97
do for [k=0:1] {
  field = word('x y', k + 1)
  levels = k == 0 ? '-2 -1 0 1 2 3 4' : '-80 -65 -60 -55 -50 -45 -40 -30 -10'  # as in drawings.hpp
  n = words(levels)
  set palette maxcolors n + 1
  set cbrange [-0.5:n + 0.5]
  set cbtics scale 0 ('' 0)
  set for [i=1:n] cbtics add (word(levels, i) i - 0.5)
  set cblabel '{/:Italic u_'.field.'} [µm]' offset 0.3,0
  set lmargin at screen 0.01 + 0.5 * k
  set rmargin at screen 0.34 + 0.5 * k
  set colorbox user origin 0.35 + 0.5 * k,0.2 size 0.025,0.6
  plot data.'/fig_12_3_'.field.'.csv' using 'x':'y':'band' with polygons fs solid noborder fc palette, \
       for [part in '_lower _upper'] data.'/fig_12_3_'.field.part.'.csv' using 'x':'y':'band' with polygons fs solid noborder fc palette, \
       for [part in '_lower _upper'] data.'/fig_12_3_mesh'.part.'.csv' using 'x':'y' with lines lc rgb GREY lw 0.3 dt 1, \
       data.'/fig_12_3_mesh.csv' using 'x':'y' with lines lc rgb GREY lw 0.3 dt 1
}
unset multiplot
