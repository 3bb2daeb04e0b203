# Figure 15.5 - one node: all equilibria of a load, and the way of the steps.
# In: fig_15_5.csv, fig_15_5_path.csv   Out: fig_15_5.svg
width = 640; height = 380
load 'style.gp'
set multiplot
set xrange [0:0.85]; set yrange [-0.08:1.15]
set xtics 0.2; set ytics 0.25
set xlabel 'push [N]' offset 0,0.4
set key off
set tmargin at screen 0.86; set bmargin at screen 0.2
file = data.'/fig_15_5.csv'; path = data.'/fig_15_5_path.csv'
is(m, name) = column('mu') == m && strcol('motion') eq name ? column('slip') : NaN
do for [m=1:3:2] {
  left = m == 1 ? 0.13 : 0.59
  set lmargin at screen left; set rmargin at screen left + 0.38
  set title sprintf('{/:Italic μ} = %d', m) offset 0,-0.5
  unset label
  if (m == 1) { set label 'slip [µm]' at screen 0.03,0.53 center rotate textcolor rgb BLACK }
  unset arrow
  set label 'open' at 0.5,0.68 right textcolor rgb BLACK
  if (m == 1) {
    set label 'sticks' at 0.22,0.0 textcolor rgb BLACK
    set label 'slides' at 0.3,0.17 textcolor rgb BLACK
  }
  if (m == 3) {
    set label 'sticks' at 0.04,0.08 textcolor rgb BLACK
    set label 'slides' at 0.42,0.15 right textcolor rgb BLACK
    set arrow from 0.6,0.03 to 0.6,0.72 head filled size 0.025,20 lw 1.3 lc rgb BLACK
  }
  plot file using 'push':(is(m, 'stick')) with lines ls 1 lw 3, \
       file using 'push':(is(m, 'forward')) with lines ls 2 lw 3, \
       file using 'push':(is(m, 'open')) with lines ls 3 lw 3, \
       path using 'push':(column('mu') == m && column('time') <= 11 ? column('slip') : NaN) with points pt 9 ps 1.1 lc rgb BLACK, \
       path using 'push':(column('mu') == m && column('time') > 11 ? column('slip') : NaN) with points pt 10 ps 1.3 lw 1.2 lc rgb BLACK
}
unset multiplot
