import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The lesson's mapping written down plainly: a list of cells for each beam,
 * each an array of two, and a look at the borders for each update.
 */
final class LessonDriver implements Driver.Mapping {
    private static final double L0 = logit(0.5);
    private static final double L_OCC = logit(0.75);
    private static final double L_FREE = logit(0.30);
    private static final double L_MIN = -8.0;
    private static final double L_MAX = 8.0;

    private final Driver.Work work;
    private double[] logOdds;

    private LessonDriver(Driver.Work work) {
        this.work = work;
    }

    private static double logit(double p) {
        return Math.log(p / (1.0 - p));
    }

    private int[] worldToGrid(double x, double y) {
        return new int[]{
                (int) Math.floor((x - work.originX()) / work.resolution()),
                (int) Math.floor((y - work.originY()) / work.resolution())};
    }

    private void updateCell(int gx, int gy, double l) {
        if (gx < 0 || gx >= work.width() || gy < 0 || gy >= work.height()) {
            return;
        }
        int cell = gy * work.width() + gx;
        logOdds[cell] += l - L0;
        if (logOdds[cell] > L_MAX) {
            logOdds[cell] = L_MAX;
        }
        if (logOdds[cell] < L_MIN) {
            logOdds[cell] = L_MIN;
        }
    }

    private static List<int[]> bresenham(int x, int y, int xEnd, int yEnd) {
        List<int[]> cells = new ArrayList<>();
        int dx = Math.abs(xEnd - x);
        int dy = Math.abs(yEnd - y);
        int xStep = x < xEnd ? 1 : -1;
        int yStep = y < yEnd ? 1 : -1;
        int error = dx - dy;
        while (true) {
            cells.add(new int[]{x, y});
            if (x == xEnd && y == yEnd) {
                return cells;
            }
            int twice = 2 * error;
            if (twice > -dy) {
                error -= dy;
                x += xStep;
            }
            if (twice < dx) {
                error += dx;
                y += yStep;
            }
        }
    }

    private void updateFromScan(Driver.WorkScan scan) {
        int[] robot = worldToGrid(scan.x(), scan.y());
        for (int i = 0; i < work.angles().length; i++) {
            double heading = scan.theta() + work.angles()[i];
            double range = Math.min(scan.ranges()[i], work.maxRange());
            int[] end = worldToGrid(scan.x() + range * Math.cos(heading),
                    scan.y() + range * Math.sin(heading));
            List<int[]> cells = bresenham(robot[0], robot[1], end[0], end[1]);
            boolean hit = range < work.maxRange() - 1e-12;
            int free = hit ? cells.size() - 1 : cells.size();
            for (int k = 0; k < free; k++) {
                updateCell(cells.get(k)[0], cells.get(k)[1], L_FREE);
            }
            if (hit) {
                updateCell(cells.get(free)[0], cells.get(free)[1], L_OCC);
            }
        }
    }

    @Override
    public void map() {
        logOdds = new double[work.width() * work.height()];
        Arrays.fill(logOdds, L0);
        for (Driver.WorkScan scan : work.scans()) {
            updateFromScan(scan);
        }
    }

    @Override
    public void write(OutputStream out) throws IOException {
        PrintStream text = new PrintStream(out);
        text.println("# logodds " + work.width() + " " + work.height());
        for (double value : logOdds) {
            text.println(value);
        }
        text.flush();
    }

    public static void main(String[] arguments) throws IOException {
        Driver.answerRequests(
                new LessonDriver(Driver.readWork(arguments[0])));
    }
}
