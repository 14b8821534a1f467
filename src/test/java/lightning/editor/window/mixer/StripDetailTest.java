package lightning.editor.window.mixer;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.editor.window.LowerDock;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StripDetailTest {
    /** Of a window's height, menus and tool bar take 118 pixels, the status line and title 50, and the dock's tabs 33. */
    @ParameterizedTest
    @CsvSource({"1000, FULL", "1080, FULL", "768, NO_INTENSITY"})
    void defaultMixer_showsThumbnailsInHighWindows(int windowHeight, StripDetail detail) {
        assertThat(StripDetail.of(LowerDock.defaultHeight(windowHeight - 168) - 33)).isEqualTo(detail);
    }
}
