package lightning.editor.window.timeline;

import java.nio.file.Path;
import java.util.Optional;
import lightning.base.text.Texts;
import lightning.format.picture.PictureFormat;
import lightning.shot.movie.MovieKind;

/** What a shot can be exported as. */
enum ShotKind {
    PNG(Texts.key("Numbered PNG, 8 bits"), PictureFormat.PNG.ending(), 8),
    PNG_FINE(Texts.key("Numbered PNG, 16 bits"), PictureFormat.PNG.ending(), 16),
    EXR(Texts.key("Numbered OpenEXR, 32 bits"), PictureFormat.EXR.ending(), 32),
    MP4(Texts.key("Film, MP4"), MovieKind.MP4.ending(), 8),
    MOV(Texts.key("Film, MOV"), MovieKind.MOV.ending(), 8),
    WEBM(Texts.key("Film, WebM"), MovieKind.WEBM.ending(), 8);

    private final String title;
    private final String ending;
    private final int bits;

    ShotKind(String title, String ending, int bits) {
        this.title = title;
        this.ending = ending;
        this.bits = bits;
    }

    /** Of the files, with its point. */
    String ending() {
        return ending;
    }

    /** Of a number. */
    int bits() {
        return bits;
    }

    /** Empty for numbered pictures. */
    Optional<MovieKind> movie() {
        return MovieKind.of(Path.of(ending));
    }

    @Override
    public String toString() {
        return Texts.of(title);
    }
}
