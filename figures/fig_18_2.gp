# Figure 18.2 - by how much each effect changes the largest pressure: estimated and computed.
# In: fig_18_2.csv   Out: fig_18_2.svg
width = 640; height = 340
load 'style.gp'
set lmargin at screen 0.27
set rmargin at screen 0.85
set tmargin at screen 0.86
set logscale x
set xrange [0.03:60]
set yrange [5.5:0.5]
set format x '%g'
set border 1
set ytics scale 0
set xlabel 'change of the largest pressure [%], without its sign'
set label 1 'computed' at screen 0.985,0.92 right
set key off
file = data.'/fig_18_2.csv'
same = "(column('estimate')*column('computed') > 0 ? abs(column('estimate')) : NaN)"
other = "(column('estimate')*column('computed') > 0 ? NaN : abs(column('estimate')))"
set label 2 'computed' at 1.4,2 right textcolor rgb BLUE
set label 3 'estimated' at 18,2 left textcolor rgb RED
plot file using (abs(column('computed'))):'place':(abs(column('estimate'))-abs(column('computed'))):(0) with vectors nohead lc rgb GREY lw 1.5 dt 1, \
     '' using (abs(column('computed'))):'place':ytic(strcol('effect')) with points pt 7 ps 1 lc rgb BLUE, \
     '' using @same:'place' with points pt 12 ps 1.9 lw 2 lc rgb RED, \
     '' using @other:'place' with points pt 2 ps 1.7 lw 2 lc rgb RED, \
     '' using (60):'place':(sprintf('%s%.2g %%', column('computed') < 0 ? '−' : '+', abs(column('computed')))) with labels offset 8.3,0 right textcolor rgb BLACK
