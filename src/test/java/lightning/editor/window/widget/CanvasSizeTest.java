package lightning.editor.window.widget;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.editor.window.command.SizeMenu;
import lightning.scene.PictureSettings;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class CanvasSizeTest {
    private static final PictureSettings PICTURE = new PictureSettings(400, 300, 0);

    @Test
    void fixedSize_inSmallWindow_isScaledDown() {
        assertThat(CanvasSize.of(600, 600).fit(300, 500, PICTURE, 1)).isEqualTo(new CanvasSize.Layout(600, 600, 300, 300));
    }

    @Test
    void fixedSize_inLargeWindow_isNotEnlarged() {
        assertThat(CanvasSize.of(200, 200).fit(900, 900, PICTURE, 1)).isEqualTo(new CanvasSize.Layout(200, 200, 200, 200));
    }

    @Test
    void pictureAspect_isKept() {
        assertThat(CanvasSize.PICTURE_ASPECT.fit(800, 1000, PICTURE, 1)).isEqualTo(new CanvasSize.Layout(800, 600, 800, 600));
    }

    @Test
    void free_usesAllPixelsOfHighDpiScreen() {
        assertThat(CanvasSize.FREE.fit(500, 300, PICTURE, 2)).isEqualTo(new CanvasSize.Layout(1000, 600, 500, 300));
    }

    @Property
    void everySize_fitsIntoTheRoom(@ForAll @DoubleRange(min = 1, max = 5000) double width,
            @ForAll @DoubleRange(min = 1, max = 5000) double height, @ForAll @IntRange(min = 0, max = 10) int which) {
        CanvasSize size = which == 0 ? CanvasSize.FREE : which == 1 ? CanvasSize.PICTURE_ASPECT : CanvasSize.FIXED.get(which - 2);
        CanvasSize.Layout frame = size.fit(width, height, PICTURE, 1);
        assertThat(frame.shownWidth()).isBetween(1.0, Math.max(1, width) + 1);
        assertThat(frame.shownHeight()).isBetween(1.0, Math.max(1, height) + 1);
        assertThat(frame.width()).isPositive();
        assertThat(frame.height()).isPositive();
    }

    @Test
    void typedSize_acceptsAnySeparator() {
        assertThat(SizeMenu.parse("640 x 480")).contains(CanvasSize.of(640, 480));
        assertThat(SizeMenu.parse("640×480")).contains(CanvasSize.of(640, 480));
    }

    @Test
    void typedNonsense_isRefused() {
        assertThat(SizeMenu.parse("640")).isEmpty();
        assertThat(SizeMenu.parse("-1 x 5")).isEmpty();
    }
}
