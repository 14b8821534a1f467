package lightning.editor.window.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import javafx.util.Duration;
import org.junit.jupiter.api.Test;

class LastingTest {
    private final HandTime time = new HandTime();
    private final List<String> seen = new ArrayList<>();
    private final Lasting remark = new Lasting(time, Lasting.NOTICED, seen::add);

    @Test
    void nothing_isSeenAtFirst() {
        assertThat(seen).containsExactly("");
    }

    @Test
    void remarkThatIsOverSoon_isNeverSeen() {
        for (int i = 0; i < 10; i++) {
            remark.tell("behind");
            time.pass(Duration.millis(99));
            remark.tell("");
        }
        time.pass(Duration.seconds(1));
        assertThat(seen).containsExactly("");
    }

    @Test
    void remarkThatLasts_isSeenAfterATenthOfASecondAndGoesAtOnce() {
        remark.tell("behind");
        time.pass(Duration.millis(99));
        assertThat(seen).containsExactly("");
        time.pass(Duration.millis(1));
        assertThat(seen).containsExactly("", "behind");
        remark.tell("");
        assertThat(seen).containsExactly("", "behind", "");
    }

    @Test
    void otherWords_areSeenAtOnceAndDoNotBeginTheWaitAnew() {
        remark.tell("behind");
        time.pass(Duration.millis(60));
        remark.tell("far behind");
        time.pass(Duration.millis(40));
        assertThat(seen).containsExactly("", "far behind");
        remark.tell("behind");
        assertThat(seen).containsExactly("", "far behind", "behind");
    }
}
