package occgrid;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The simulated world: walls, ray casting, range scans (lesson section 6).
 */
public final class World {
    private World() {
    }

    /**
     * Where the robot (or its laser) stands.
     *
     * @param x metres
     * @param y metres
     * @param theta heading, radians
     */
    public record Pose(double x, double y, double theta) {
    }

    /**
     * A wall from (x0, y0) to (x1, y1).
     *
     * @param x0 metres
     * @param y0 metres
     * @param x1 metres
     * @param y1 metres
     */
    public record Segment(double x0, double y0, double x1, double y1) {
    }

    // [snippet: box-world]
    /**
     * The four walls of a rectangle, counterclockwise from the lower one.
     *
     * @param xmin left, metres
     * @param ymin below, metres
     * @param xmax right, metres
     * @param ymax above, metres
     * @return a list that more walls may be added to
     */
    public static List<Segment> buildBoxWorld(double xmin, double ymin,
            double xmax, double ymax) {
        return new ArrayList<>(List.of(
                new Segment(xmin, ymin, xmax, ymin),
                new Segment(xmax, ymin, xmax, ymax),
                new Segment(xmax, ymax, xmin, ymax),
                new Segment(xmin, ymax, xmin, ymin)));
    }

    /**
     * A wall along y.
     *
     * @param x metres
     * @param y0 metres
     * @param y1 metres
     * @return the wall
     */
    public static Segment addVerticalWall(double x, double y0, double y1) {
        return new Segment(x, y0, x, y1);
    }

    /**
     * A wall along x.
     *
     * @param y metres
     * @param x0 metres
     * @param x1 metres
     * @return the wall
     */
    public static Segment addHorizontalWall(double y, double x0, double x1) {
        return new Segment(x0, y, x1, y);
    }
    // [/snippet]

    // [snippet: ray-segment-intersection]
    /**
     * The distance at which a ray meets a wall.
     *
     * @param rx the ray's point, metres
     * @param ry the ray's point, metres
     * @param rdx the ray's direction
     * @param rdy the ray's direction
     * @param wall the wall
     * @return metres; infinity where the ray is parallel or misses
     */
    public static double raySegmentIntersection(double rx, double ry,
            double rdx, double rdy, Segment wall) {
        double sx = wall.x1() - wall.x0();
        double sy = wall.y1() - wall.y0();
        double rxs = rdx * sy - rdy * sx;
        if (Math.abs(rxs) < 1e-12) {
            return Double.POSITIVE_INFINITY;
        }
        double qpx = wall.x0() - rx;
        double qpy = wall.y0() - ry;
        double t = (qpx * sy - qpy * sx) / rxs;
        double u = (qpx * rdy - qpy * rdx) / rxs;
        boolean meets = t >= 0.0 && u >= 0.0 && u <= 1.0;
        return meets ? t : Double.POSITIVE_INFINITY;
    }
    // [/snippet]

    // [snippet: simulate-lidar-scan]
    /**
     * Ranges along bearings from a pose. A beam that meets no wall within
     * zMax reads zMax.
     *
     * @param pose the sensor's pose
     * @param walls the world
     * @param angles (n) bearings from the heading, radians
     * @param zMax the sensor's maximum range, metres
     * @return (n) metres
     */
    public static double[] simulateLidarScan(Pose pose, List<Segment> walls,
            double[] angles, double zMax) {
        double[] ranges = new double[angles.length];
        Arrays.fill(ranges, zMax);
        for (int i = 0; i < angles.length; i++) {
            double beam = pose.theta() + angles[i];
            double rdx = PortableMath.cos(beam);
            double rdy = PortableMath.sin(beam);
            for (Segment wall : walls) {
                double t = raySegmentIntersection(pose.x(), pose.y(), rdx,
                        rdy, wall);
                ranges[i] = Math.min(ranges[i], t);
            }
        }
        return ranges;
    }
    // [/snippet]
}
