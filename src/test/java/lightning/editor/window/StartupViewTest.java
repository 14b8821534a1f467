package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicReference;
import javafx.application.Platform;
import javafx.geometry.Bounds;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.layout.Region;
import javafx.scene.paint.Paint;
import javafx.stage.Stage;
import lightning.document.FileThread;
import lightning.editor.Command;
import lightning.editor.window.model.PanelPlace;
import lightning.editor.window.model.WindowLayout;
import lightning.editor.window.model.WindowLayout.CanvasLayout;
import lightning.editor.window.widget.ColorTheme;
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

@ExtendWith(JavaFxRequirement.class)
@Slow
class StartupViewTest {
    private static final Offset<Double> ONE_PIXEL = within(1.0);

    @TempDir
    private Path folder;

    private final FileThread thread = new FileThread(Platform::runLater);
    private Stage stage;
    private final WindowLayout layout = new WindowLayout();
    private StartupView startupView;
    private StartupSession startupSession;

    @BeforeEach
    void register() throws Exception {
        FxToolkit.registerPrimaryStage();
    }

    @AfterEach
    void close() throws Exception {
        FxToolkit.setupFixture(() -> {
            if (startupSession != null) {
                startupSession.close();
            }
            stage.close();
            ColorTheme.DARK.apply();
        });
        thread.close();
    }

    private void show(ColorTheme looks, double width, double height) throws Exception {
        FxToolkit.setupFixture(() -> {
            stage = new Stage();
            startupView = new StartupView(looks, layout);
            stage.setScene(new Scene(startupView, width, height));
            stage.show();
            looks.apply();
        });
    }

    /** Shows other content in the window with the current styles. */
    private void change(Parent content) {
        ColorTheme.style(stage.getScene());
        stage.getScene().setRoot(content);
        content.applyCss();
        content.layout();
    }

    private static double[] edges(Bounds place) {
        return new double[] {place.getMinX(), place.getMinY(), place.getMaxX(), place.getMaxY()};
    }

    private Bounds pictureBounds() {
        return startupView.picture().localToScene(startupView.picture().getLayoutBounds());
    }

    @ParameterizedTest
    @CsvSource({"1600, 950", "1600, 811", "1597, 949", "1366, 768"})
    void picture_whenPaneAppears_staysInPlace(double width, double height) throws Exception {
        show(ColorTheme.DARK, width, height);
        Path file = Files.writeString(folder.resolve("scene.jen"), "jen 1\npicture { size 40 30 }\nsphere ball { }\n");
        FxToolkit.setupFixture(() -> {
            startupView.layout();
            Bounds before = pictureBounds();
            var frame = new EditorLayout(file, startupView.picture());
            frame.reserve(layout);
            change(frame);
            Bounds framed = pictureBounds();
            startupSession = TestEditors.startupSession(file, frame, folder, thread);
            frame.applyCss();
            frame.layout();
            assertThat(edges(framed)).containsExactly(edges(before), ONE_PIXEL);
            assertThat(edges(pictureBounds())).containsExactly(edges(before), ONE_PIXEL);
        });
    }

    @ParameterizedTest
    @EnumSource(value = CanvasLayout.class, names = "PREVIEW_ALONE", mode = EnumSource.Mode.EXCLUDE)
    void picture_withDocks_staysInPlaceUntilTheyAreFilled(CanvasLayout canvases) throws Exception {
        layout.canvasLayoutProperty().set(canvases);
        layout.panelsProperty().set(layout.panelsProperty().get().open(Command.MIXER).open(Command.HISTORY_PANEL)
                .move(Command.HISTORY_PANEL, PanelPlace.LEFT));
        layout.dockSizeProperty(PanelPlace.BELOW).set(200);
        show(ColorTheme.DARK, 1600, 950);
        Path file = Files.writeString(folder.resolve("scene.jen"), "jen 1\npicture { size 40 30 }\nsphere ball { }\n");
        AtomicReference<double[]> before = new AtomicReference<>();
        AtomicReference<EditorLayout> frame = new AtomicReference<>();
        FxToolkit.setupFixture(() -> {
            startupView.layout();
            before.set(edges(pictureBounds()));
            frame.set(new EditorLayout(file, startupView.picture()));
            frame.get().reserve(layout);
            change(frame.get());
        });
        FxToolkit.setupFixture(() -> {
            frame.get().layout();
            assertThat(edges(pictureBounds())).containsExactly(before.get(), ONE_PIXEL);
        });
    }

    private static Paint background(Region region) {
        return region.getBackground().getFills().getLast().getFill();
    }

    @ParameterizedTest
    @EnumSource
    void backgrounds_matchTheme(ColorTheme looks) throws Exception {
        show(looks, 1600, 950);
        FxToolkit.setupFixture(() -> {
            var frame = TestEditors.layout(folder.resolve("scene.jen"));
            Paint[] before = {background(startupView), background(startupView.canvases()), background(startupView.headers())};
            change(frame);
            assertThat(new Paint[] {background(frame), background((Region) frame.lookup(".canvas")),
                background((Region) frame.lookup(".pane-header"))})
                    .isEqualTo(before);
        });
    }
}
