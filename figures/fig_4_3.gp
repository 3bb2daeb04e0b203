# Figure 4.3 - how often the printed method is right, by size.   In: fig_4_3.csv   Out: fig_4_3.svg
width = 600; height = 400
load 'style.gp'
set xrange [-0.7:13.7]
set yrange [0:100]
set ylabel 'share of runs [%]'
set xlabel 'unknowns {/:Italic n}, below them rows {/:Italic m}' offset 0,-0.8
unset grid; set grid ytics back ls 101
set key outside top center horizontal width -2 maxrows 2
set boxwidth 0.8
set xtics scale 0
set style fill solid 1.0 border lc rgb BLACK
place(n, row) = row + (n > 10) + (n > 20)
plot data.'/fig_4_3.csv' using (place(column('n'), $0)):(column('one')+column('limit')+column('feasible')):xtic(sprintf("%d\n%d", column('n'), column('m'))) with boxes fc rgb LIGHT lw 0.8 dt 1 title 'feasible only', \
     '' using (place(column('n'), $0)):(column('one')+column('limit')) with boxes fc rgb SKY lw 0.8 dt 1 title 'optimal, from a limit', \
     '' using (place(column('n'), $0)):'one' with boxes fc rgb BLUE lw 0.8 dt 1 title 'optimal, one step', \
     '' using (place(column('n'), $0)):(100*exp(-column('fresh'))) with points pt 7 ps 0.9 lc rgb ORANGE title 'exp(−ν)', \
     '' using (place(column('n'), $0)):(100*exp(-column('fresh'))) with points pt 6 ps 0.9 lc rgb BLACK notitle
