package occgrid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import occgrid.World.Pose;
import occgrid.World.Segment;
import org.junit.jupiter.api.Test;

class WorldTest {
    private static final double NONE = Double.POSITIVE_INFINITY;

    private static double meet(double rx, double ry, double rdx, double rdy) {
        return World.raySegmentIntersection(rx, ry, rdx, rdy,
                new Segment(2.0, -1.0, 2.0, 3.0));
    }

    @Test
    void aRayMeetsAWall() {
        assertEquals(2.0, meet(0.0, 0.0, 1.0, 0.0));
        assertEquals(4.0, meet(0.0, 0.0, 0.5, 0.0));
        assertEquals(0.0, meet(2.0, 1.0, 1.0, 0.0));
        // the ends belong to the wall
        assertEquals(2.0, meet(0.0, 3.0, 1.0, 0.0));
        assertEquals(2.0, meet(0.0, -1.0, 1.0, 0.0));
        assertEquals(2.5, meet(0.0, 1.5, 0.8, -0.6));
    }

    @Test
    void aRayMisses() {
        assertEquals(NONE, meet(0.0, 3.1, 1.0, 0.0));
        assertEquals(NONE, meet(0.0, -1.1, 1.0, 0.0));
        // behind, parallel, nearly parallel, in line with the wall
        assertEquals(NONE, meet(3.0, 0.0, 1.0, 0.0));
        assertEquals(NONE, meet(0.0, 0.0, 0.0, 1.0));
        assertEquals(NONE, meet(0.0, 0.0, 2e-13, 1.0));
        assertEquals(NONE, meet(2.0, -5.0, 0.0, 1.0));
        // a slope below 1e-12 is parallel, though this one would meet
        assertEquals(NONE, meet(2.0 - 1e-13, 0.0, 2e-13, 1.0));
        assertEquals(1.0 / 3.0, meet(2.0 - 1e-13, 0.0, 3e-13, 1.0), 1e-3);
    }

    @Test
    void theBoxRunsCounterclockwise() {
        assertEquals(List.of(new Segment(-1, -2, 3, -2),
                new Segment(3, -2, 3, 4), new Segment(3, 4, -1, 4),
                new Segment(-1, 4, -1, -2)),
                World.buildBoxWorld(-1, -2, 3, 4));
        assertEquals(new Segment(5, 1, 5, 2), World.addVerticalWall(5, 1, 2));
        assertEquals(new Segment(1, 5, 2, 5),
                World.addHorizontalWall(5, 1, 2));
    }

    @Test
    void aScanSeesTheNearestWall() {
        List<Segment> walls = List.of(World.addVerticalWall(4.0, -9, 9),
                World.addVerticalWall(3.0, -9, 9),
                World.addVerticalWall(5.0, -9, 9),
                World.addHorizontalWall(10.0, -9, 9));
        double[] angles = {0.0, PortableMath.PI / 2.0, PortableMath.PI, 0.1};
        double[] ranges = World.simulateLidarScan(new Pose(0.0, 0.0, 0.0),
                walls, angles, 7.0);
        assertArrayEquals(new double[]{3.0, 7.0, 7.0,
                3.0 / StrictMath.cos(0.1)}, ranges, 1e-12);
        assertEquals(3.0, ranges[0]);
        assertEquals(7.0, ranges[1]);
    }
}
