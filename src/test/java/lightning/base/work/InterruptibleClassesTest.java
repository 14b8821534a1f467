package lightning.base.work;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.function.IntUnaryOperator;
import org.junit.jupiter.api.Test;

class InterruptibleClassesTest {

    /** Loops of several forms, one without an end. */
    public static final class Loops implements IntUnaryOperator {
        @Override
        public int applyAsInt(int n) {
            int sum = 0;
            for (int i = 0; i < n; i++) {
                int k = i;
                do {
                    sum += k;
                } while (--k > i - 2);
            }
            while (n < 0) {
                sum++;
            }
            return sum;
        }
    }

    private static IntUnaryOperator copy() throws ReflectiveOperationException {
        var classes = new InterruptibleClasses(Loops.class.getClassLoader(), Loops.class.getName());
        return (IntUnaryOperator) classes.loadClass(Loops.class.getName()).getDeclaredConstructor().newInstance();
    }

    @Test
    void copy_computesTheSame() throws Exception {
        IntUnaryOperator copy = copy();
        assertThat(copy).isNotInstanceOf(Loops.class);
        assertThat(copy.applyAsInt(100)).isEqualTo(new Loops().applyAsInt(100));
    }

    @Test
    void loopWithoutEnd_endsByInterrupt() throws Exception {
        IntUnaryOperator copy = copy();
        Thread.currentThread().interrupt();
        assertThatExceptionOfType(Error.class).isThrownBy(() -> copy.applyAsInt(-1)).withMessage("interrupted");
        assertThat(Thread.interrupted()).isTrue();
    }
}
