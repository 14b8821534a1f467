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
import lightning.bench.accuracy.Grade;
import lightning.bench.accuracy.Ladder;
import lightning.bench.accuracy.PictureError;
import lightning.bench.accuracy.Rung;
import lightning.bench.accuracy.Timing;
import lightning.editor.window.JavaFxNeeds;
import lightning.editor.window.OnStage;
import lightning.editor.window.QuickRobot;
import lightning.render.shading.TraceCounts;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;

@ExtendWith({JavaFxNeeds.class, OnStage.class})
@Slow
class LadderPlotTest {
    private LadderPlot chart;

    @Start
    private void start(Stage stage) {
        chart = new LadderPlot();
        stage.setScene(new Scene(chart, 420, 380));
        stage.show();
    }

    private static Rung rung(Grade grade) {
        double ms = grade == Grade.FULL_TRACE ? 100 : 0.1;
        return new Rung(grade, new Timing(List.of(ms)), new PictureError(0, 1, 0, 0, 0, 0, 0, 0, 1, 0), null, null);
    }

    @Test
    void labelOfManyLevelsWithoutTime_isReadInFull(FxRobot robot) {
        robot.interact(() -> chart.show(new Ladder(null, null, null, Stream.of(Grade.values()).map(LadderPlotTest::rung).toList(),
                TraceCounts.NONE, true)));
        QuickRobot.settle();
        // All but the full trace, which takes its time.
        String levels = IntStream.range(1, Grade.values().length).mapToObj(Integer::toString).collect(Collectors.joining(" "));
        Node label = robot.lookup(levels).query();
        Node plot = robot.lookup(".chart-plot-background").query();
        Bounds shown = label.localToScreen(label.getBoundsInLocal());
        assertThat(shown.getMinX()).isGreaterThanOrEqualTo(plot.localToScreen(plot.getBoundsInLocal()).getMinX());
        assertThat(shown.getWidth()).isGreaterThan(50);
    }
}
