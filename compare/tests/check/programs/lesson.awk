# A mapper for the lesson in awk, with awk's own sin, cos, exp and log; it prints the picture.
# usage: awk -f lesson.awk [-v bug=NAME] SCENARIO > map.pgm         (without noise)
function floor(v,  n) { n = int(v); return n > v ? n - 1 : n }
function cell(v) { return bug == "rounded" ? floor(v + 0.5) : floor(v) }
function abs(v) { return v < 0 ? -v : v }
function logit(q) { return log(q / (1 - q)) }
function update(gx, gy, step,  l) {
    if (gx < 0 || gx >= P["width"] || gy < 0 || gy >= P["height"]) return
    l = grid[gx, gy] + step
    if (l > P["l_max"]) l = P["l_max"]
    if (l < P["l_min"]) l = P["l_min"]
    grid[gx, gy] = l
}
function start(  gx, gy, i, required) {
    started = 1
    split("width height resolution origin_x origin_y max_range", required, " ")
    for (i in required) if (!(required[i] in P)) fail("occgrid_" required[i] " is missing")
    l0 = bug == "prior" ? 0 : logit(P["p0"])
    occ = logit(P["p_occ"]) - l0
    free = logit(P["p_free"]) - l0
    for (gy = 0; gy < P["height"]; gy++) for (gx = 0; gx < P["width"]; gx++) grid[gx, gy] = logit(P["p0"])
}
function simulate(x, y, a,  dx, dy, best, i, sx, sy, rxs, qx, qy, t, u) {
    dx = cos(a); dy = sin(a); best = P["max_range"]
    for (i = 1; i <= walls; i++) {
        sx = X1[i] - X0[i]; sy = Y1[i] - Y0[i]
        rxs = dx * sy - dy * sx
        if (abs(rxs) < 1e-12) continue
        qx = X0[i] - x; qy = Y0[i] - y
        t = (qx * sy - qy * sx) / rxs
        u = (qx * dy - qy * dx) / rxs
        if (t >= 0 && u >= 0 && u <= 1 && t < best) best = t
    }
    return best
}
function trace(x, y, a, z, hit,  gx, gy, gx1, gy1, dx, dy, sx, sy, err, e2, end) {
    gx = cell((x - P["origin_x"]) / P["resolution"]); gy = cell((y - P["origin_y"]) / P["resolution"])
    gx1 = cell((x + z * cos(a) - P["origin_x"]) / P["resolution"])
    gy1 = cell((y + z * sin(a) - P["origin_y"]) / P["resolution"])
    dx = abs(gx1 - gx); dy = abs(gy1 - gy)
    sx = gx < gx1 ? 1 : -1; sy = gy < gy1 ? 1 : -1
    err = dx - dy
    while (1) {
        end = gx == gx1 && gy == gy1
        if (!(end && bug == "last")) update(gx, gy, end && hit ? occ : free)
        if (end) return
        e2 = 2 * err
        if (e2 > -dy) { err -= dy; gx += sx }
        if (e2 < dx) { err += dx; gy += sy }
    }
}
function beam(x, y, theta, angle, text,  z, a, hit) {
    if (text ~ /[nN][aA][nN]/) return
    a = theta + angle
    if (text == "") z = simulate(x, y, a)
    else if (text ~ /[iI][nN][fF]/) z = P["max_range"]
    else z = text + 0
    if (text != "" && z < P["min_range"]) return
    hit = z < P["max_range"] - 1e-12
    if (!hit && P["no_return"] == "ignore") return
    if (!hit) z = P["max_range"]
    trace(x, y, a, z, hit)
}
BEGIN {
    pi = 3.141592653589793
    P["p0"] = 0.5; P["p_occ"] = 0.75; P["p_free"] = 0.3; P["l_min"] = -8; P["l_max"] = 8
    P["no_return"] = "free"; P["fov"] = pi; P["beams"] = 181
}
{ sub(/\r$/, "") }
function fail(reason) { printf "%s:%d: %s\n", FILENAME, NR, reason > "/dev/stderr"; failed = 1; exit 1 }
function is_number(text) { return text ~ /^[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?$/ }
$1 == "PARAM" && $2 ~ /^occgrid_/ {
    if (started) fail("PARAM must stand before the first scan")
    if ($2 != "occgrid_no_return" && !is_number($3)) fail("not a number")
    if ($2 ~ /^occgrid_p/ && ($3 <= 0 || $3 >= 1)) fail("not between 0 and 1")
}
$1 == "POSE" && (NF < 4 || $4 ~ /^#/ || $3 ~ /^#/ || !is_number($2) || !is_number($3) || !is_number($4)) { fail("POSE takes 3 values") }
$1 == "FLASER" { for (i = 3; i < 3 + $2; i++) if ($i ~ /^-[0-9.]*[1-9]/) fail("a range is negative") }
$1 == "PARAM" && $2 ~ /^occgrid_/ { P[substr($2, 9)] = $3 == "free" || $3 == "ignore" ? $3 : $3 + 0 }
$1 == "WALL" { walls++; X0[walls] = $2; Y0[walls] = $3; X1[walls] = $4; Y1[walls] = $5 }
$1 == "POSE" {
    if (!started) start()
    n = P["beams"]
    for (i = 0; i < n; i++) beam($2 + 0, $3 + 0, $4 + 0, n == 1 ? 0 : -(P["fov"] / 2) + (P["fov"] * i) / (n - 1), "")
}
$1 == "FLASER" {
    if (!started) start()
    n = $2
    step = n == 1 ? 0 : pi / (n == 180 || n == 181 ? 180 : n == 360 || n == 361 ? 360 : n == 400 || n == 401 ? 720 : n - 1)
    for (i = 0; i < n; i++) beam($(n + 3) + 0, $(n + 4) + 0, $(n + 5) + 0, -(pi / 2) + i * step, $(i + 3))
}
$1 == "ROBOTLASER1" {
    if (!started) start()
    n = $9; m = $(10 + n)
    for (i = 0; i < n; i++) beam($(11 + n + m) + 0, $(12 + n + m) + 0, $(13 + n + m) + 0, $3 + i * $5, $(10 + i))
}
END {
    if (failed) exit 1
    print "P2"; print P["width"], P["height"]; print 255
    for (gy = P["height"] - 1; gy >= 0; gy--) {
        for (gx = 0; gx < P["width"]; gx++) {
            l = grid[gx, gy]
            p = l >= 0 ? 1 / (1 + exp(-l)) : exp(l) / (1 + exp(l))
            printf "%d%s", floor((1 - p) * 255 + 0.5), gx < P["width"] - 1 ? " " : "\n"
        }
    }
}
