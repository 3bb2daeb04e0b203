# Figure 11.6 - displacements of both bodies, 40 times as large.
# In: fig_11_6.csv, fig_11_6_x_disc.csv, fig_11_6_x_plate.csv, the same with y and size   Out: fig_11_6.svg
width = 860; height = 600
load 'style.gp'
set size ratio -1
unset key; unset grid; unset border
set tics scale 0.4
set xtics (0, 50)
set xlabel '{/:Italic x} [mm]' offset 0,0.7
set ylabel '{/:Italic y} [mm]' offset 1.2,0
set xrange [-3:98]
set yrange [-98:52]
set palette maxcolors 11
set cbrange [-0.5:10.5]
set cbtics scale 0 offset 0,0.4
names = 'x y size'
titles = 'u_x u_y |u|'
levels_1 = '"" -1 "" 0 "" 1 "" 3 "" 7'
levels_2 = '-60 "" -50 "" -40 "" -20 "" -5 ""'
levels_3 = '"" 5 "" 20 "" 40 "" 50 "" 60'
set multiplot
do for [panel=1:3] {
  set lmargin at screen 0.105 + 0.305 * (panel - 1)
  set ytics (-95, 0, 50)
  if (panel > 1) { set format y ''; unset ylabel }
  set rmargin at screen 0.385 + 0.305 * (panel - 1)
  set bmargin at screen 0.28
  set tmargin at screen 0.92
  set colorbox horizontal user origin 0.11 + 0.305 * (panel - 1),0.1 size 0.27,0.035
  set title word(titles, panel).' [µm]' offset 0,-0.5
  levels = value('levels_'.panel)
  set cbtics ('' 0)
  do for [k=1:10] { if (word(levels, k) ne '') { set cbtics add (word(levels, k) k - 0.5) } }
  plot for [body in 'plate disc'] data.'/fig_11_6_'.word(names, panel).'_'.body.'.csv' using 'x':'y':'band' with polygons fs solid noborder fc palette, \
       data.'/fig_11_6.csv' using 'x':'y' with lines lc rgb GREY lw 1.4 dt (6,4)
}
unset multiplot
