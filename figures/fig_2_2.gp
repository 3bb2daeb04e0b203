# Figure 2.2 - s between two vertices, printed and repaired.   In: fig_2_2.csv   Out: fig_2_2.svg
load 'style.gp'
set xlabel 'weight of the overlapping pair'
set ylabel '{/:Italic s}'
set xrange [0:1]
set yrange [0:2.2]
plot data.'/fig_2_2.csv' using 'weight':'printed' with lines ls 2 title '(23) and (24) as printed', \
     '' using 'weight':'repaired' with lines ls 1 title 'with the positive part'
