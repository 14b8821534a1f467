package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class CompilersTest {
    private final double[] worked = {1000};
    private final double[] now = {5000};
    private final Compilers.Watch watch = new Compilers(() -> worked[0], () -> now[0]).watch();

    private void pass(double ms, double of) {
        worked[0] += of;
        now[0] += ms;
    }

    @Test
    void compilersRest_belowATwentiethOfTheTime() {
        pass(100, 4);
        assertThat(watch.isResting()).isTrue();
        pass(0, 2);
        assertThat(watch.isResting()).isFalse();
        pass(100, 0);
        assertThat(watch.isResting()).isTrue();
    }
}
