package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.bench.result.SampleResults;
import lightning.bench.result.SystemLoad;
import lightning.bench.result.TimeSamples;
import org.junit.jupiter.api.Test;

class SystemLoadTest {
    /** Returns times from fields 14 to 17 of proc(5): user, kernel, children's user and children's kernel time. */
    private static ProcessorTime time(int own, int children, int busy, int idle) {
        String process = "7 (a (b) c) S 1 7 7 0 -1 4194304 100 0 0 0 " + own + " 10 " + children + " 5 20 0 1 0 82426";
        // user nice system idle iowait irq softirq steal guest guest_nice
        String machine = "cpu  " + busy + " 1 2 " + idle + " 30 3 4 5 6 7\ncpu0 9 9 9 9 9 9 9 9 9 9\n";
        return ProcessorTime.parse(process, machine);
    }

    @Test
    void processorTime_parsesProcFiles() {
        ProcessorTime time = time(100, 40, 500, 900);
        assertThat(time.own()).isEqualTo(100 + 10);
        assertThat(time.children()).isEqualTo(40 + 5);
        assertThat(time.busy()).as("includes stolen time, excludes I/O wait").isEqualTo(500 + 1 + 2 + 3 + 4 + 5);
        assertThat(time.all()).isEqualTo(time.busy() + 900 + 30);
    }

    @Test
    void otherShare_excludesThisProcessAndChildren() {
        // 250 of 400 ticks were busy, 100 by this process and 50 by its children.
        assertThat(time(200, 90, 750, 1050).otherShareSince(time(100, 40, 500, 900))).isCloseTo(100 / 400.0, within(1e-12));
        // Ticks of a process may be counted before those of the machine.
        assertThat(time(300, 40, 510, 990).otherShareSince(time(100, 40, 500, 900))).isZero();
    }

    @Test
    void busy_isJudgedByOtherShareOrElseByLoad() {
        assertThat(new SystemLoad(0, 9, 0.09).isBusy(2)).isFalse();
        assertThat(new SystemLoad(5, 9, 0.09).isBusy(2)).as("load of its own build").isFalse();
        assertThat(new SystemLoad(0, 2, 0.11).isBusy(2)).isTrue();
        assertThat(new SystemLoad(0.9, 9, Double.NaN).isBusy(2)).isFalse();
        assertThat(new SystemLoad(1.1, 2, Double.NaN).isBusy(2)).isTrue();
        assertThat(new SystemLoad(Double.NaN, Double.NaN, Double.NaN).isBusy(2)).isFalse();
    }

    @Test
    void samples_areDistinctIfQuartilesDoNotOverlap() {
        // Quartiles of 1, 2, 3 are 1.5 and 2.5.
        TimeSamples fast = SampleResults.samples(1, 2, 3);
        assertThat(fast.isDistinctFrom(SampleResults.samples(3, 4, 5))).isTrue();
        assertThat(SampleResults.samples(3, 4, 5).isDistinctFrom(fast)).isTrue();
        assertThat(fast.isDistinctFrom(SampleResults.samples(2, 3, 4))).as("2.5 to 3.5 touches the other").isFalse();
        assertThat(fast.isDistinctFrom(SampleResults.samples(1, 2, 9))).isFalse();
        assertThat(fast.isDistinctFrom(SampleResults.samples(100, 101))).as("too few for quartiles").isFalse();
        assertThat(SampleResults.samples(1).isDistinctFrom(SampleResults.samples(100))).isFalse();
    }
}
