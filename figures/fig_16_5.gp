# Figure 16.5 - seconds of every phase on four times the mesh: predicted from this one, and measured.
# In: fig_16_5.csv   Out: fig_16_5.svg
width = 760; height = 460
load 'style.gp'
set multiplot layout 1,2
set logscale x
set format x '10^{%T}'
set xrange [1e-4:2]
set tmargin at screen 0.76
set bmargin at screen 0.24
set yrange [8.7:-0.7]
set border 1
set ytics scale 0 ('plan' 0, 'assembly' 1, 'ordering' 2, 'symbolic' 3, 'numeric' 4, 'condensation' 5, 'contact' 6, 'refinement' 7, 'recovery' 8)
set grid noytics
set xlabel 'seconds'
file = data.'/fig_16_5.csv'
do for [k=0:1] {
  set lmargin at screen (k == 0 ? 0.22 : 0.61)
  set rmargin at screen (k == 0 ? 0.58 : 0.97)
  if (k == 1) { unset key; unset ytics } else { set key at screen 0.97, screen 0.98 top right horizontal maxrows 1 }
  set title (k == 0 ? 'Hertz' : 'cantilever') offset 0,-0.5
  plot file every :::k::k using 'predicted ≈':($0-0.17):'predicted low ≈':'predicted high ≈' with xerrorbars pt 6 ps 1.1 lw 1.5 lc rgb RED title 'predicted', \
       '' every :::k::k using 'measured ≈':($0+0.17):'low ≈':'high ≈' with xerrorbars pt 7 ps 0.9 lw 1.5 lc rgb BLUE title 'measured'
}
unset multiplot
