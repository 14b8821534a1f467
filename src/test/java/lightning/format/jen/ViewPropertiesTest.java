package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import lightning.scene.PictureSettings;
import lightning.scene.ViewCurve;
import lightning.scene.ViewSettings;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The view transform in the picture's block. */
class ViewPropertiesTest {
    private static JenDocument read(String text) throws JenException {
        return JenReader.read(text, "a.jen", Path.of("scenes"));
    }

    @Test
    void missingProperties_areDefaultAndNotWritten() throws JenException {
        JenDocument document = read("jen 1 picture { size 30 20 }");
        assertThat(document.scene().picture().view()).isEqualTo(new ViewSettings(ViewCurve.SRGB, 0));
        assertThat(JenWriter.write(document.scene())).isEqualTo("jen 1\n\npicture { size 30 20 }\n");
    }

    @Property
    void view_roundTripsThroughNewAndSavedFiles(@ForAll ViewCurve curve, @ForAll @DoubleRange(min = -64, max = 64) double exposure)
            throws JenException {
        JenDocument plain = read("jen 1 # kept\npicture { size 30 20 }\n");
        PictureSettings picture = plain.scene().picture().withView(new ViewSettings(curve, exposure + 0.0));
        JenDocument edited = plain.withScene(plain.scene().withPicture(picture));
        assertThat(read(edited.text()).scene()).isEqualTo(edited.scene());
        assertThat(edited.text()).contains("# kept");
        assertThat(read(JenWriter.write(edited.scene())).scene()).isEqualTo(edited.scene());
        assertThat(edited.withScene(plain.scene()).scene()).isEqualTo(plain.scene());
    }

    @Test
    void edits_setView() throws Exception {
        JenDocument document = read("jen 1 picture { view agx  exposure -1.5 }");
        assertThat(document.scene().picture().view()).isEqualTo(new ViewSettings(ViewCurve.AGX, -1.5));
        assertThat(JenWriter.write(document.scene())).isEqualTo("jen 1\n\npicture { view agx  exposure -1.5 }\n");
    }

    /** False colors and clipping marks are for viewing only. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "view false | view must be srgb, linear, filmic, aces, aces2 or agx, was 'false'",
        "view 1998 | view",
        "exposure 65 | exposure must be from -64 to 64"})
    void invalidView_isRejected(String property, String message) {
        assertThatThrownBy(() -> read("jen 1 picture { " + property + " }")).isInstanceOf(JenException.class).hasMessageContaining(message);
    }
}
