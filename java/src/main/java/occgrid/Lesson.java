package occgrid;

import java.util.ArrayList;
import java.util.List;
import occgrid.Scenario.Settings;
import occgrid.Scenario.Simulated;
import occgrid.Sensor.NoReturn;
import occgrid.World.Pose;
import occgrid.World.Segment;

/**
 * The lesson, built in (lesson section 6): a robot drives an ellipse in a
 * box with two inner walls.
 */
public final class Lesson {
    private Lesson() {
    }

    // [snippet: lesson-settings]
    /**
     * Grid, inverse sensor model and simulated sensor of the lesson.
     *
     * @return the settings
     */
    public static Settings lessonSettings() {
        int width = 220;
        int height = 180;
        double resolution = 0.1;
        double originX = -11.0;
        double originY = -9.0;
        double maxRange = 10.0;
        double minRange = 0.0;
        double p0 = 0.5;
        double pOcc = 0.75;
        double pFree = 0.30;
        double lMin = -8.0;
        double lMax = 8.0;
        double fov = PortableMath.PI;
        int beams = 181;
        double noiseStd = 0.02;
        return new Settings(width, height, resolution, originX, originY,
                maxRange, minRange, p0, pOcc, pFree, lMin, lMax,
                NoReturn.FREE, fov, beams, noiseStd);
    }
    // [/snippet]

    // [snippet: lesson-world]
    /**
     * A box of 20 m x 16 m, a vertical and a horizontal wall in it.
     *
     * @return the walls
     */
    public static List<Segment> lessonWorld() {
        List<Segment> walls = World.buildBoxWorld(-10.0, -8.0, 10.0, 8.0);
        walls.add(World.addVerticalWall(0.0, -6.0, 6.0));
        walls.add(World.addHorizontalWall(2.0, -8.0, -2.0));
        return walls;
    }
    // [/snippet]

    // [snippet: lesson-poses]
    /**
     * 120 poses on an ellipse, the heading along it.
     *
     * @return the poses in order
     */
    public static List<Pose> lessonPoses() {
        List<Pose> poses = new ArrayList<>();
        for (int t = 0; t < 120; t++) {
            double ang = 2.0 * PortableMath.PI * (t / 120.0);
            double x = -6.0 + 6.0 * PortableMath.cos(ang);
            double y = 0.0 + 4.0 * PortableMath.sin(ang);
            poses.add(new Pose(x, y, ang + PortableMath.PI / 2.0));
        }
        return poses;
    }
    // [/snippet]

    /**
     * The lesson as a scenario, named {@code lesson}.
     *
     * @return the scenario
     */
    public static Scenario lessonScenario() {
        return new Scenario("lesson", lessonSettings(), lessonWorld(),
                lessonPoses().stream().map(Simulated::new).toList());
    }
}
