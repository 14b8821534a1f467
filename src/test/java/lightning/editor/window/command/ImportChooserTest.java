package lightning.editor.window.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javafx.scene.Scene;
import javafx.stage.Stage;
import lightning.base.work.Await;
import lightning.document.imports.ImportPreviews;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.StageExtension;
import lightning.format.exchange.ImportLighting;
import lightning.format.exchange.assembly.LightUnits;
import lightning.render.image.Film;
import lightning.sample.Slow;
import lightning.scene.PictureSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.testfx.framework.junit5.Start;
import org.testfx.util.WaitForAsyncUtils;

@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class ImportChooserTest {
    private static final PictureSettings PICTURE = PictureSettings.DEFAULT.withSize(280, 210);

    private final List<ImportPreviews.Choice> choices = new ArrayList<>();
    private Stage stage;

    @Start
    void open(Stage given) {
        stage = given;
        for (LightUnits units : LightUnits.values()) {
            choices.add(new ImportPreviews.Choice(ImportLighting.FILE, Optional.of(units)));
        }
        for (ImportLighting lighting : List.of(ImportLighting.STUDIO, ImportLighting.SKY)) {
            choices.add(new ImportPreviews.Choice(lighting, Optional.empty()));
        }
    }

    private double width(double maxWidth) {
        return WaitForAsyncUtils.waitForAsyncFx(TimeUnit.SECONDS.toMillis(Await.TIMEOUT_SECONDS), () -> {
            var cards = new ImportChooser(choices, PICTURE, maxWidth, () -> {});
            choices.forEach(choice -> cards.show(choice, new ImportPreviews.Preview(Film.black(280, 210), -9)));
            stage.setScene(new Scene(cards));
            cards.applyCss();
            return cards.prefWidth(-1);
        });
    }

    @ParameterizedTest
    @ValueSource(doubles = {640, 920})
    void smallScreen_fitsAllPictures(double maxWidth) {
        assertThat(width(maxWidth)).isLessThanOrEqualTo(maxWidth);
    }

    @Test
    void largeScreen_showsPicturesAtFullSize() {
        assertThat(width(1880)).isEqualTo(width(3800)).isGreaterThan(5 * 280);
    }
}
