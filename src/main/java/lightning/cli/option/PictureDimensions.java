package lightning.cli.option;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.text.Quote;
import lightning.scene.value.SceneLimits;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Image size in pixels, written {@code 640x480} on the command line. */
public record PictureDimensions(int width, int height) {
    private static final Pattern PATTERN = Pattern.compile("(\\d{1,9})[xX×](\\d{1,9})");

    public static final class Converter implements ITypeConverter<PictureDimensions> {
        @Override
        public PictureDimensions convert(String text) {
            Matcher form = PATTERN.matcher(text);
            if (!form.matches()) {
                throw new TypeConversionException("expected WIDTHxHEIGHT in pixels such as 640x480, found " + Quote.of(text));
            }
            PictureDimensions size = new PictureDimensions(Integer.parseInt(form.group(1)), Integer.parseInt(form.group(2)));
            if (Math.min(size.width, size.height) < 1 || Math.max(size.width, size.height) > SceneLimits.MAX_SIZE) {
                throw new TypeConversionException(
                        "width and height must be from 1 to " + SceneLimits.MAX_SIZE + ", found " + Quote.of(text));
            }
            return size;
        }
    }
}
