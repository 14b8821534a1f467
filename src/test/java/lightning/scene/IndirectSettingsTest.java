package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class IndirectSettingsTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "0 | 64 | 8 | indirect: bounces must be from 1 to 8, was 0",
        "9 | 64 | 8 | indirect: bounces must be from 1 to 8, was 9",
        "2 | 32 | 8 | indirect: rays must be 16, 64, 256 or 1024, was 32",
        "2 | 64 | 1 | indirect: spacing must be from 2 to 64, was 1",
        "2 | 64 | 65 | indirect: spacing must be from 2 to 64, was 65",
    })
    void valueOutsideRange_isRejected(int bounces, int rays, int spacing, String message) {
        assertThatThrownBy(() -> new IndirectSettings(bounces, rays, spacing, false)).isInstanceOf(IllegalArgumentException.class)
                .hasMessage(message);
    }

    @Test
    void label_namesAllSettings() {
        assertThat(IndirectSettings.DEFAULT.label()).isEqualTo("2 bounces, 64 rays, every 8 pixels");
        assertThat(new IndirectSettings(1, 16, 2, true).label()).isEqualTo("1 bounce, 16 rays, every 2 pixels, background");
    }

    @ParameterizedTest
    @CsvSource({"1920, 1080, 8", "480, 270, 8", "3840, 2160, 16", "1080, 1920, 8", "2160, 3840, 16", "4000, 1080, 8", "1620, 1620, 12"})
    void spacing_countsPixelsOfFullHd(int width, int height, double pixels) {
        assertThat(new GatherSettings(2, 64, 8, false, 0).pixelSpacing(new PictureSettings(width, height, 0))).isEqualTo(pixels);
    }

    @Test
    void attributes_setOneValueEach() {
        IndirectSettings all = IndirectSettings.BOUNCES.with(IndirectSettings.DEFAULT, 5);
        all = IndirectSettings.RAYS.with(all, 256);
        all = IndirectSettings.SPACING.with(all, 32);
        all = IndirectSettings.BACKGROUND.with(all, true);
        assertThat(all).isEqualTo(new IndirectSettings(5, 256, 32, true));
    }

    @Test
    void otherPictureSettings_keepIndirectLight() {
        PictureSettings picture = new PictureSettings(3, 2, 1).withIndirect(Optional.of(IndirectSettings.DEFAULT));
        assertThat(new PictureSettings(3, 2, 1, SamplingSettings.DEFAULT).indirect()).isEmpty();
        assertThat(picture.withSize(5, 4).withDepth(3).withSampling(new SamplingSettings(AntialiasMode.EVERY, 2)))
                .isEqualTo(new PictureSettings(5, 4, 3, new SamplingSettings(AntialiasMode.EVERY, 2),
                        Optional.of(IndirectSettings.DEFAULT)));
    }
}
