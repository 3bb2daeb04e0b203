# Figure 18.2 - by how much each effect changes the largest pressure: estimated and computed.
# In: fig_18_2.csv   Out: fig_18_2.svg
width = 640; height = 360
load 'style.gp'
set lmargin at screen 0.27
set rmargin at screen 0.97
set logscale x
set xrange [0.02:200]
set yrange [5.6:-0.4]
set format x '%g'
set border 1
set ytics scale 0
set grid noytics
set xlabel 'change of the largest pressure [%], without its sign'
set key top right horizontal
plot data.'/fig_18_2.csv' using (abs(column('computed'))):'place':(0.02):(abs(column('computed'))):(column('place')-0.28):(column('place')+0.28):ytic(strcol('effect')) with boxxyerror lc rgb SKY fs solid border lc rgb BLUE title 'computed', \
     '' using (column('estimate')*column('computed') > 0 ? abs(column('estimate')) : NaN):'place' with points pt 13 ps 1.6 lc rgb RED title 'estimated', \
     '' using (column('estimate')*column('computed') > 0 ? NaN : abs(column('estimate'))):'place' with points pt 12 ps 1.8 lw 2 lc rgb RED notitle, \
     '' using (190):'place':(sprintf('%+.2g %%', column('computed'))) with labels right textcolor rgb BLACK notitle
