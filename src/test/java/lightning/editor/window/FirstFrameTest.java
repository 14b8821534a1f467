package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import javafx.application.Platform;
import javafx.geometry.Bounds;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.layout.Region;
import javafx.scene.paint.Paint;
import javafx.stage.Stage;
import lightning.editor.document.FileThread;
import lightning.editor.window.widget.Looks;
import lightning.sample.Slow;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.testfx.api.FxToolkit;

@ExtendWith(JavaFxNeeds.class)
@Slow
class FirstFrameTest {
    private static final Offset<Double> A_PIXEL = within(1.0);

    @TempDir
    private Path folder;

    private final FileThread thread = new FileThread(Platform::runLater);
    private Stage stage;
    private FirstFrame first;
    private FirstSight sight;

    @BeforeEach
    void register() throws Exception {
        FxToolkit.registerPrimaryStage();
    }

    @AfterEach
    void close() throws Exception {
        FxToolkit.setupFixture(() -> {
            if (sight != null) {
                sight.close();
            }
            stage.close();
            Looks.DARK.wear();
        });
        thread.close();
    }

    private void show(Looks looks, double width, double height) throws Exception {
        FxToolkit.setupFixture(() -> {
            stage = new Stage();
            first = new FirstFrame(looks);
            stage.setScene(new Scene(first, width, height));
            stage.show();
            looks.wear();
        });
    }

    /** Shows something else in the window, with the looks that it has then. */
    private void change(Parent content) {
        Looks.dress(stage.getScene());
        stage.getScene().setRoot(content);
        content.applyCss();
        content.layout();
    }

    private static double[] edges(Bounds place) {
        return new double[] {place.getMinX(), place.getMinY(), place.getMaxX(), place.getMaxY()};
    }

    private Bounds place() {
        return first.picture().localToScene(first.picture().getLayoutBounds());
    }

    @ParameterizedTest
    @CsvSource({"1600, 950", "1600, 811", "1597, 949", "1366, 768"})
    void picture_staysWhereItIsWhileItsPaneComes(double width, double height) throws Exception {
        show(Looks.DARK, width, height);
        Path file = Files.writeString(folder.resolve("scene.jen"), "jen 1\npicture { size 40 30 }\nsphere ball { }\n");
        FxToolkit.setupFixture(() -> {
            first.layout();
            Bounds before = place();
            var frame = new EditorFrame(file, first.picture());
            change(frame);
            Bounds framed = place();
            sight = OpenEditor.sight(file, frame, folder, thread);
            frame.applyCss();
            frame.layout();
            assertThat(edges(framed)).containsExactly(edges(before), A_PIXEL);
            assertThat(edges(place())).containsExactly(edges(before), A_PIXEL);
        });
    }

    private static Paint ground(Region region) {
        return region.getBackground().getFills().getLast().getFill();
    }

    @ParameterizedTest
    @EnumSource
    void grounds_areThoseOfTheTheme(Looks looks) throws Exception {
        show(looks, 1600, 950);
        FxToolkit.setupFixture(() -> {
            var frame = OpenEditor.frame(folder.resolve("scene.jen"));
            Paint[] before = {ground(first), ground(first.canvases()), ground(first.heads())};
            change(frame);
            assertThat(new Paint[] {ground(frame), ground((Region) frame.lookup(".canvas")), ground((Region) frame.lookup(".pane-header"))})
                    .isEqualTo(before);
        });
    }
}
