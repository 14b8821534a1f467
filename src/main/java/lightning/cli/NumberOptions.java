package lightning.cli;

import java.math.BigDecimal;
import java.util.function.Function;
import lightning.base.text.Decimal;
import lightning.base.text.Quote;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Numbers on the command line are those of scene files; picocli's own reading takes {@code 0x10}, {@code 010} and {@code 1d} too. */
final class NumberOptions {
    private NumberOptions() {}

    /** Makes all commands read numbers so; those that belong to commands already added, too. */
    static void register(CommandLine commands) {
        ITypeConverter<Integer> whole = text -> whole(text, BigDecimal::intValueExact);
        ITypeConverter<Long> large = text -> whole(text, BigDecimal::longValueExact);
        commands.registerConverter(int.class, whole).registerConverter(Integer.class, whole);
        commands.registerConverter(long.class, large).registerConverter(Long.class, large);
        commands.registerConverter(double.class, NumberOptions::number).registerConverter(Double.class, NumberOptions::number);
    }

    private static <T> T whole(String text, Function<BigDecimal, T> exactly) {
        if (Decimal.read(text).isPresent()) {
            try {
                return exactly.apply(new BigDecimal(text));
            } catch (ArithmeticException | NumberFormatException e) {
                // A fraction, or too large: a sentence for both.
            }
        }
        throw new TypeConversionException("expected a whole number, found " + Quote.of(text));
    }

    private static double number(String text) {
        return Decimal.read(text).orElseThrow(() -> new TypeConversionException("expected a number, found " + Quote.of(text)));
    }
}
