package lightning.cli.option;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.text.Quote;
import lightning.scene.shot.Shot;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Range of consecutive frames: {@code 1-240} or {@code 17}. */
public record FrameRange(int first, int last) {
    static final int MAX_FRAMES = 100_000;

    public int count() {
        return last - first + 1;
    }

    /** Parses a frame range of the command line. */
    static final class Converter implements ITypeConverter<FrameRange> {
        private static final Pattern RANGE = Pattern.compile("([0-9]{1,10})(?:-([0-9]{1,10}))?");

        @Override
        public FrameRange convert(String text) {
            Matcher range = RANGE.matcher(text);
            if (!range.matches()) {
                throw new TypeConversionException("expected frames such as 1-240 or 17, found " + Quote.of(text));
            }
            long first = Long.parseLong(range.group(1));
            long last = range.group(2) == null ? first : Long.parseLong(range.group(2));
            if (last > Shot.MAX_FRAME || last < first || last - first >= MAX_FRAMES) {
                throw new TypeConversionException("expected at most " + MAX_FRAMES + " frames from 0 to " + Shot.MAX_FRAME
                        + ", the first not after the last, found " + Quote.of(text));
            }
            return new FrameRange((int) first, (int) last);
        }
    }
}
