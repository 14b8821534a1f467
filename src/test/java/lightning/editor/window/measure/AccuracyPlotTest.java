package lightning.editor.window.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.stage.Stage;
import lightning.editor.window.FastRobot;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.ScreenBounds;
import lightning.editor.window.StageExtension;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.AccuracySweep;
import lightning.render.measure.PictureError;
import lightning.render.measure.SweepPoint;
import lightning.render.measure.Timing;
import lightning.render.shading.RayCounts;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;

@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class AccuracyPlotTest {
    private AccuracyPlot chart;

    @Start
    private void start(Stage stage) {
        chart = new AccuracyPlot();
        stage.setScene(new Scene(chart, 420, 380));
        stage.show();
    }

    private static SweepPoint sweepPoint(AccuracySetting grade) {
        double ms = grade == AccuracySetting.FULL_TRACE ? 100 : 0.1;
        return new SweepPoint(grade, new Timing(List.of(ms)), new PictureError(0, 1, 0, 0, 0, 0, 0, 0, 1, 0), null, null);
    }

    @Test
    void labelOfManyLevels_isNotClipped(FxRobot robot) {
        robot.interact(() -> chart
                .show(new AccuracySweep(null, null, null, Stream.of(AccuracySetting.values()).map(AccuracyPlotTest::sweepPoint).toList(),
                        RayCounts.NONE, true)));
        FastRobot.settle();
        // All settings except the full trace, which is slow.
        String levels = IntStream.range(1, AccuracySetting.values().length).mapToObj(Integer::toString).collect(Collectors.joining(" "));
        Node label = robot.lookup(levels).query();
        Node plot = robot.lookup(".chart-plot-background").query();
        Bounds shown = ScreenBounds.of(label);
        assertThat(shown.getMinX()).isGreaterThanOrEqualTo(ScreenBounds.of(plot).getMinX());
        assertThat(shown.getWidth()).isGreaterThan(50);
    }
}
