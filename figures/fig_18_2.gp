# Figure 18.2 - by how much each effect changes the largest pressure: estimated and computed.
# In: fig_18_2.csv   Out: fig_18_2.svg
width = 640; height = 360
load 'style.gp'
set lmargin at screen 0.28
set rmargin at screen 0.97
set logscale x
set xrange [0.02:100]
set yrange [5.7:0.3]
set format x '%g'
unset ytics
set border 1
set xlabel 'change of the largest pressure [%]'
set key bottom right
plot data.'/fig_18_2.csv' using (abs(column('computed'))):'place':(0.02):(abs(column('computed'))):(column('place')-0.28):(column('place')+0.28) with boxxyerror lc rgb SKY fs solid border lc rgb BLUE title 'computed', \
     '' using (abs(column('estimate'))):'place' with points pt 13 ps 1.6 lc rgb RED title 'estimated', \
     '' using (0.017):'place':(strcol('effect')) with labels right textcolor rgb BLACK notitle, \
     '' using (abs(column('computed'))*1.12 > abs(column('estimate'))*0.8 && abs(column('computed')) < abs(column('estimate')) ? abs(column('estimate'))*1.3 : abs(column('computed')) < abs(column('estimate')) ? abs(column('computed'))*1.12 : abs(column('computed'))*1.35):'place':(sprintf('%+.2g %%', column('computed'))) with labels left textcolor rgb BLACK notitle
