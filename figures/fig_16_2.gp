# Figure 16.2 - what an error costs: one line per element, operator and solver, one point per mesh.
# In: fig_16_2.csv   Out: fig_16_2.svg
width = 760; height = 520
load 'style.gp'
eval LOGLOG
set xlabel 'seconds, from the scene to certified forces' offset 2,0
set ylabel 'error of the pressure [% of {/:Italic q}_0]'
set xrange [3e-4:30]
set yrange [3e-3:200]
set key outside right top noopaque
set rmargin 27
file = data.'/fig_16_2.csv'
s = "column('seconds ≈')"
e = "(column('solved') > 0 && column('error') > 0 ? column('error') : NaN)"
plot 1 with lines ls 8 lw 0.8 notitle, 0.1 with lines ls 8 lw 0.8 notitle, \
     file every :::0::0 using (@s):@e with linespoints ls 1 title 'q4 incompatible', \
     '' every :::1::1 using (@s):@e with linespoints ls 3 title 'its nodes meet', \
     '' every :::2::2 using (@s):@e with linespoints ls 5 title 'q4', \
     '' every :::3::3 using (@s):@e with linespoints ls 2 title 'q8', \
     '' every :::4::4 using (@s):@e with linespoints ls 4 title 'nodes on segments', \
     '' every :::5::5 using (@s):@e with linespoints ls 6 title 'pairs at Gauss points', \
     '' every :::6::6 using (@s):@e with linespoints lc rgb BLACK lw 1 dt (2,2) pt 8 ps 1.3 title 'the same by sweeps', \
     '' every :::6::6 using (column('solved') > 0 ? NaN : @s):(100) with points pt 2 ps 1.4 lw 2.5 lc rgb BLACK title 'no solution', \
     '' every :::7::7 using (@s):@e with linespoints ls 8 lw 2 title 'not condensed'
