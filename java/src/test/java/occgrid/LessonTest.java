package occgrid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalLong;
import java.util.stream.IntStream;
import occgrid.Grid.OccupancyGrid;
import occgrid.World.Pose;
import org.junit.jupiter.api.Test;

class LessonTest {
    @Test
    void thePathIsAnEllipse() {
        List<Pose> poses = Lesson.lessonPoses();
        assertEquals(120, poses.size());
        assertEquals(new Pose(0.0, 0.0, 1.5707963267948966), poses.get(0));
        assertEquals(-12.0, poses.get(60).x());
        for (Pose pose : poses) {
            double x = (pose.x() + 6.0) / 6.0;
            double y = pose.y() / 4.0;
            assertEquals(1.0, x * x + y * y, 1e-14);
        }
    }

    @Test
    void theWorldHasSixWalls() {
        assertEquals(6, Lesson.lessonWorld().size());
    }

    private static OccupancyGrid map(OptionalLong seed) {
        return Mapper.mapScenario(Lesson.lessonScenario(), seed);
    }

    @Test
    void theMapShowsTheRoom() {
        OccupancyGrid grid = map(OptionalLong.empty());
        assertEquals(39_600, grid.logOdds().length);
        // the left wall is seen, the middle of the room is free
        long walls = IntStream.range(20, 160)
                .filter(gy -> grid.logOdds(10, gy) > 0
                        || grid.logOdds(9, gy) > 0)
                .count();
        assertTrue(walls > 40, walls + " cells of the left wall");
        var robot = grid.worldToGrid(-6.0, 0.0);
        assertTrue(grid.logOdds(robot.gx(), robot.gy()) < -3.0);
        // nobody has seen the right half's far corner
        assertEquals(0.0, grid.logOdds(219, 179));
    }

    @Test
    void theFileIsTheSameScenario() {
        String file = Path.of(System.getProperty("occgrid.basedir"),
                "../scenarios/lesson.log").toString();
        for (OptionalLong seed : new OptionalLong[]{OptionalLong.empty(),
                OptionalLong.of(0)}) {
            try (Scenario scenario = Scenario.readScenario(file)) {
                assertEquals(Lesson.lessonSettings(), scenario.settings());
                assertEquals(Lesson.lessonWorld(), scenario.walls());
                OccupancyGrid grid = Mapper.mapScenario(scenario, seed);
                assertTrue(Arrays.equals(map(seed).logOdds(), grid.logOdds()));
            }
        }
    }

    @Test
    void noiseDependsOnTheSeedOnly() {
        double[] first = map(OptionalLong.of(1)).logOdds();
        assertTrue(Arrays.equals(first, map(OptionalLong.of(1)).logOdds()));
        assertTrue(!Arrays.equals(first, map(OptionalLong.of(2)).logOdds()));
    }
}
