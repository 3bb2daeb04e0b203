# Figure 1.3 - two bodies: how far i' moves relative to i along the normal and along the tangent.
# In: fig_1_3.csv, fig_1_3_nodes.csv, fig_1_3_arrows.csv   Out: fig_1_3.svg
height = 530
load 'style.gp'
unset grid
unset border
unset tics
unset key
set lmargin 1
set rmargin 1
set bmargin 0.5
set tmargin 0.5
set xrange [-4.7:5.3]
set yrange [-4.5:3.9]
set size ratio -1
theta = 25*pi/180
t_x = cos(theta); t_y = sin(theta); n_x = t_y; n_y = -t_x  # n here is minus the normal: downwards
set arrow 1 from n_x*1+1.2*t_x,n_y*1+1.2*t_y to n_x*1+1.2*t_x+2.0,n_y*1+1.2*t_y nohead ls 8 front
do for [k=0:9] { a = theta*k/10; b = theta*(k+1)/10; set arrow 10+k from n_x+1.2*t_x+1.3*cos(a),n_y+1.2*t_y+1.3*sin(a) to n_x+1.2*t_x+1.3*cos(b),n_y+1.2*t_y+1.3*sin(b) nohead ls 7 front }
set label 1 'θ' at n_x+1.2*t_x+1.75,n_y+1.2*t_y+0.38 center font ',19' textcolor rgb BLACK front
set label 2 "i'" at -0.25,0.42 center font ',19' textcolor rgb BLACK front
set label 3 'i' at n_x-0.05,n_y-0.45 center font ',19' textcolor rgb BLACK front
set label 4 'n' at -3*t_x+n_x*0.3-0.35,-3*t_y+n_y*0.3 center font ',19' textcolor rgb BLACK front
set label 5 't' at -1.9*t_x+n_x-0.1,-1.9*t_y+n_y+0.35 center font ',19' textcolor rgb BLACK front
set label 6 'a_iu' at 0.3*n_x-0.3*t_x,0.3*n_y-0.3*t_y center font ',19' textcolor rgb RED front
set label 7 'slip' at 0.8*n_x+1.15*t_x,0.8*n_y+1.15*t_y center font ',15' rotate by 25 textcolor rgb BLACK front
file = data.'/fig_1_3_arrows.csv'
plot data.'/fig_1_3.csv' using 'x':'y' every :::0::0 with filledcurves closed fc rgb '#dcebf5', \
     '' using 'x':'y' every :::1::1 with filledcurves closed fc rgb LIGHT, \
     '' using 'x':'y' with lines ls 7, \
     data.'/fig_1_3_nodes.csv' using 'x':'y' with points pt 7 ps 0.9 lc rgb BLACK, \
     file using 'x':'y':'dx':'dy' every ::3::4 with vectors size screen 0.02,20 filled lw 2.5 dt 1 lc rgb BLUE, \
     '' using 'x':'y':'dx':'dy' every ::0::0 with vectors size screen 0.018,20 filled lw 1.6 dt 1 lc rgb BLACK, \
     '' using 'x':'y':'dx':'dy' every ::1::1 with vectors size screen 0.018,20 filled lw 2.5 dt 1 lc rgb RED, \
     '' using 'x':'y':'dx':'dy' every ::2::2 with vectors size screen 0.02,20 filled lw 2 dt 1 lc rgb BLACK
