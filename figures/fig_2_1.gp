# Figure 2.1 - s between an open and an overlapping pair: what the condition eta >= 0 excludes.
# In: fig_2_1.csv   Out: fig_2_1.svg
load 'style.gp'
set xlabel 'weight of the overlapping pair'
set ylabel '{/:Italic s}' offset 1,0
set xrange [0:1]
set yrange [0:2.2]
set key
set arrow 1 from 2./3,0 to 2./3,1.2 nohead ls 8
set label 1 'η < 0: excluded' at 0.65,1.1 right
set label 2 'η ≥ 0' at 0.69,1.1 left
plot data.'/fig_2_1.csv' using 'weight':'without_constraint' with lines ls 2 title 'without the condition', \
     '' using 'weight':'positive_part' with lines ls 1 lw 3 title 'with the positive part'
