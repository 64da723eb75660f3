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
    /** Log-odds of every cell; not final, as in the lesson, and quicker so. */
    private static final class Grid {
        int width;
        int height;
        double resolution;
        double originX;
        double originY;
        double l0 = logit(0.5);
        double lOcc = logit(0.75);
        double lFree = logit(0.30);
        double lMin = -8.0;
        double lMax = 8.0;
        double[] logOdds;

        Grid(Driver.Work work) {
            width = work.width();
            height = work.height();
            resolution = work.resolution();
            originX = work.originX();
            originY = work.originY();
            logOdds = new double[width * height];
            Arrays.fill(logOdds, l0);
        }

        int[] worldToGrid(double x, double y) {
            return new int[]{(int) Math.floor((x - originX) / resolution),
                    (int) Math.floor((y - originY) / resolution)};
        }

        boolean inBounds(int gx, int gy) {
            return 0 <= gx && gx < width && 0 <= gy && gy < height;
        }

        void updateCell(int gx, int gy, double l) {
            if (!inBounds(gx, gy)) {
                return;
            }
            int cell = gy * width + gx;
            logOdds[cell] += l - l0;
            if (logOdds[cell] > lMax) {
                logOdds[cell] = lMax;
            }
            if (logOdds[cell] < lMin) {
                logOdds[cell] = lMin;
            }
        }
    }

    private final Driver.Work work;
    private Grid grid;

    private LessonDriver(Driver.Work work) {
        this.work = work;
    }

    private static double logit(double p) {
        return Math.log(p / (1.0 - p));
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

    private static void updateFromScan(Grid grid, Driver.WorkScan scan,
            double[] angles, double zMax) {
        int[] robot = grid.worldToGrid(scan.x(), scan.y());
        for (int i = 0; i < angles.length; i++) {
            double heading = scan.theta() + angles[i];
            double range = Math.min(scan.ranges()[i], zMax);
            int[] end = grid.worldToGrid(scan.x() + range * Math.cos(heading),
                    scan.y() + range * Math.sin(heading));
            List<int[]> cells = bresenham(robot[0], robot[1], end[0], end[1]);
            boolean hit = range < zMax - 1e-12;
            int free = hit ? cells.size() - 1 : cells.size();
            for (int k = 0; k < free; k++) {
                int[] cell = cells.get(k);
                grid.updateCell(cell[0], cell[1], grid.lFree);
            }
            if (hit) {
                int[] last = cells.get(free);
                grid.updateCell(last[0], last[1], grid.lOcc);
            }
        }
    }

    @Override
    public void map() {
        grid = new Grid(work);
        for (Driver.WorkScan scan : work.scans()) {
            updateFromScan(grid, scan, work.angles(), work.maxRange());
        }
    }

    @Override
    public void write(OutputStream out) throws IOException {
        PrintStream text = new PrintStream(out);
        text.println("# logodds " + work.width() + " " + work.height());
        for (double value : grid.logOdds) {
            text.println(value);
        }
        text.flush();
    }

    public static void main(String[] arguments) throws IOException {
        Driver.answerRequests(
                new LessonDriver(Driver.readWork(arguments[0])));
    }
}
