# Figure 22.3 - a node in a bowl: how far it is from where it ends, with a normal that stands and one that turns.
# In: fig_22_3.csv   Out: fig_22_3.svg
load 'style.gp'
eval LOGY
file = data.'/fig_22_3.csv'
set xlabel 'iteration'
set ylabel 'distance from the end [mm]' offset 1,0
set xrange [1:20]
set xtics (1, 5, 10, 15, 20)
set yrange [1e-12:30]
set ytics 1e-12,1e3
set key at 19.5,2e-10 right Left reverse
of(w, t) = abs(column('weight') - w) < 1e-9 && column('turns') == t ? column('error') : NaN
set label '{/:Italic λ}/{/:Italic rk} = 1.42' at 20,3.5 right
set label '0.92' at 20,4e-3 right
set label '0.43' at 20,3e-7 right
set label '0.04' at 9.3,1e-11
plot file using 'iteration':(of(1.5, 0)) with linespoints ls 1 title 'frozen normal', \
     '' using 'iteration':(of(1.0, 0)) with linespoints ls 1 notitle, \
     '' using 'iteration':(of(0.5, 0)) with linespoints ls 1 notitle, \
     '' using 'iteration':(of(0.1, 0)) with linespoints ls 1 notitle, \
     '' using 'iteration':(of(1.5, 1)) with linespoints ls 2 title 'turning normal', \
     '' using 'iteration':(of(1.0, 1)) with linespoints ls 2 notitle, \
     '' using 'iteration':(of(0.5, 1)) with linespoints ls 2 notitle, \
     '' using 'iteration':(of(0.1, 1)) with linespoints ls 2 notitle
