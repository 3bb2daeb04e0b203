# Figure 19.1 - the force after each pass, over that of the solution.   In: fig_19_1.csv   Out: fig_19_1.svg
height = 470
load 'style.gp'
file = data.'/fig_19_1.csv'
set xlabel 'pass'
set ylabel 'force over that of the solution'
set xrange [0:8]
set xtics 1
set yrange [0:2.4]
set ytics 0.5
set key at screen 0.03,0.02 left bottom maxrows 3 samplen 2.5 noopaque
set bmargin at screen 0.375
set arrow 1 from 0,1 to 8,1 nohead back ls 8
plot file using 'pass':'short' with linespoints ls 1 title 'Uzawa, step 0.5', \
     '' using 'pass':'long' with linespoints ls 2 title 'Uzawa, step 1.6', \
     '' using 'pass':'too_long' with linespoints ls 8 lc rgb BLACK title 'Uzawa, step 2.2', \
     '' using 'pass':'augmented' with linespoints ls 3 title 'augmented Lagrangian, 2', \
     '' using 'pass':'penalty' with linespoints ls 4 title 'penalty, 2', \
     1 with lines ls 7 title 'active set, Nitsche'
