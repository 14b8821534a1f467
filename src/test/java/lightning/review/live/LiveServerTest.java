package lightning.review.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Answers of the server of live reviews to clients that are no pages. */
class LiveServerTest {
    private static final String CHANGE = "{\"page\":\"p\",\"reviewer\":\"\",\"lights\":[],\"groups\":[],\"notes\":[]}";

    private final List<LiveChange> changes = new ArrayList<>();
    private final HttpClient client = HttpClient.newHttpClient();
    private LiveReview review;

    @BeforeEach
    void start() throws IOException {
        review = LiveReview.start("studio.jen", LiveAddress.LOCAL, true, changes::add);
    }

    @AfterEach
    void close() {
        review.close();
        client.close();
    }

    private HttpResponse<String> send(String url, String method, String body) throws Exception {
        HttpRequest.BodyPublisher publisher =
                body.isEmpty() ? HttpRequest.BodyPublishers.noBody() : HttpRequest.BodyPublishers.ofString(body);
        return client.send(HttpRequest.newBuilder(URI.create(url)).method(method, publisher).build(), HttpResponse.BodyHandlers.ofString());
    }

    @Test
    void address_isOfThisComputerOnly() {
        assertThat(review.url()).startsWith("http://127.0.0.1:");
    }

    @Test
    void addresses_ofTwoReviewsDiffer() throws IOException {
        try (LiveReview other = LiveReview.start("studio.jen", LiveAddress.LOCAL, true, changes::add)) {
            String token = URI.create(review.url()).getPath();
            assertThat(token).hasSizeGreaterThanOrEqualTo(34).isNotEqualTo(URI.create(other.url()).getPath());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "data", "events", "layer/0", "x/", "%2e%2e/data"})
    void pathWithoutToken_isUnknown(String path) throws Exception {
        String root = review.url().substring(0, review.url().indexOf('/', 8) + 1);
        assertThat(send(root + path, "GET", "").statusCode()).isEqualTo(404);
        assertThat(send(root + "a".repeat(32) + "/" + path, "GET", "").statusCode()).isEqualTo(404);
    }

    @Test
    void page_mayConnectToItsServerOnly() throws Exception {
        HttpResponse<String> page = send(review.url(), "GET", "");
        assertThat(page.body()).contains("default-src 'none'").contains("connect-src 'self'").doesNotContain("{{");
        assertThat(page.headers().firstValue("Cache-Control")).contains("no-store");
        assertThat(page.headers().firstValue("Referrer-Policy")).contains("no-referrer");
    }

    @Test
    void data_isUnknownBeforeTheFirstPicture() throws Exception {
        assertThat(send(review.url() + "data", "GET", "").statusCode()).isEqualTo(404);
    }

    @ParameterizedTest
    @CsvSource({"PUT,data", "POST,data", "GET,change", "DELETE,''"})
    void otherMethod_isRefused(String method, String path) throws Exception {
        assertThat(send(review.url() + path, method, method.equals("GET") ? "" : "x").statusCode()).isEqualTo(405);
    }

    @Test
    void change_isReceived() throws Exception {
        String body = CHANGE.replace("\"lights\":[]",
                "\"lights\":[{\"name\":\"sun\",\"intensity\":2.5,\"color\":[1,0.5,0],\"mute\":true,\"solo\":false}]");
        assertThat(send(review.url() + "change", "POST", body).statusCode()).isEqualTo(204);
        assertThat(changes.getFirst().state().lights()).containsExactly(
                new LiveState.LightValue("sun", 2.5, new lightning.base.math.Rgb(1, 0.5, 0), true, false));
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "", "x", "[]", "{}", "{\"lights\":1}",
        "{\"page\":\"p\",\"reviewer\":\"\",\"lights\":[{}],\"groups\":[],\"notes\":[]}",
        "{\"page\":\"p\",\"reviewer\":\"\",\"lights\":[{\"name\":\"a\",\"intensity\":-1,\"color\":[1,1,1],\"mute\":true,\"solo\":false}],\"groups\":[],\"notes\":[]}",
        "{\"page\":\"p\",\"reviewer\":\"\",\"lights\":[{\"name\":\"a\",\"intensity\":1e300,\"color\":[1,1,1],\"mute\":true,\"solo\":false}],\"groups\":[],\"notes\":[]}",
        "{\"page\":\"p\",\"reviewer\":\"\",\"lights\":[{\"name\":\"a\",\"intensity\":1,\"color\":[2,1,1],\"mute\":true,\"solo\":false}],\"groups\":[],\"notes\":[]}",
        "{\"page\":\"p\",\"reviewer\":\"\",\"lights\":[],\"groups\":[],\"notes\":[{\"x\":2,\"y\":0,\"text\":\"a\"}]}",
        "{\"page\":\"p\",\"reviewer\":\"\",\"lights\":[],\"groups\":[],\"notes\":[],\"exposure\":1e9}"})
    void wrongChange_getsOneSentence(String body) throws Exception {
        HttpResponse<String> answer = send(review.url() + "change", "POST", body);
        assertThat(answer.statusCode()).isEqualTo(400);
        assertThat(answer.body()).startsWith("change:").doesNotContain("Exception").doesNotContain("\n");
        assertThat(changes).isEmpty();
    }

    @Test
    void hugeChange_isRefused() throws Exception {
        assertThat(send(review.url() + "change", "POST", " ".repeat(2 << 20)).statusCode()).isEqualTo(413);
    }

    @Test
    void change_isForbiddenUnlessAllowed() throws Exception {
        try (LiveReview readOnly = LiveReview.start("studio.jen", LiveAddress.LOCAL, false, changes::add)) {
            assertThat(send(readOnly.url() + "change", "POST", CHANGE).statusCode()).isEqualTo(403);
            assertThat(changes).isEmpty();
        }
    }

    @Test
    void otherComputers_needACertificate() {
        assertThatThrownBy(() -> LiveReview.start("x", new LiveAddress("0.0.0.0", 0, Optional.empty()), false, changes::add))
                .isInstanceOf(IOException.class).hasMessageContaining("needs a certificate");
    }

    @Test
    void unknownAddress_getsOneSentence() {
        assertThatThrownBy(() -> LiveReview.start("x", new LiveAddress("no such host", 0, Optional.empty()), false, changes::add))
                .isInstanceOf(IOException.class).hasMessageContaining("found 'no such host'");
    }

    @Test
    void usedPort_getsOneSentence() {
        int port = URI.create(review.url()).getPort();
        assertThatThrownBy(() -> LiveReview.start("x", new LiveAddress("127.0.0.1", port, Optional.empty()), false, changes::add))
                .isInstanceOf(IOException.class).hasMessageContaining("cannot listen");
    }

    private static String withNotes(String page, int count, int length) {
        String note = "{\"x\":0.5,\"y\":0.5,\"text\":\"" + "a".repeat(length) + "\"}";
        return CHANGE.replace("\"page\":\"p\"", "\"page\":\"" + page + "\"").replace("\"notes\":[]",
                "\"notes\":[" + String.join(",", Collections.nCopies(count, note)) + "]");
    }

    @ParameterizedTest
    @CsvSource({"201,1", "11,9999"})
    void tooManyNotesOfAPage_getOneSentence(int count, int length) throws Exception {
        HttpResponse<String> answer = send(review.url() + "change", "POST", withNotes("p", count, length));
        assertThat(answer.statusCode()).isEqualTo(400);
        assertThat(answer.body()).startsWith("change: notes: expected at most 200 notes").doesNotContain("\n");
        assertThat(changes).isEmpty();
    }

    @Test
    void notesOfTooManyPages_getOneSentence() throws Exception {
        for (int page = 0; page < 100; page++) {
            assertThat(send(review.url() + "change", "POST", withNotes("p" + page, 1, 1)).statusCode()).isEqualTo(204);
        }
        HttpResponse<String> answer = send(review.url() + "change", "POST", withNotes("another", 1, 1));
        assertThat(answer.statusCode()).isEqualTo(429);
        assertThat(answer.body()).isEqualTo("This review has notes of 100 pages, and takes no notes of another one.");
        assertThat(send(review.url() + "change", "POST", withNotes("p7", 2, 1)).statusCode()).isEqualTo(204);
        assertThat(send(review.url() + "change", "POST", withNotes("another", 0, 1)).statusCode()).isEqualTo(204);
    }

    /** They send only a part of a head; a few bytes of it keep coming. */
    @Test
    void connectionsWithoutTheToken_keepNobodyOut() throws Exception {
        URI url = URI.create(review.url());
        List<Socket> strangers = new ArrayList<>();
        try {
            for (int i = 0; i < 600; i++) {
                Socket stranger = new Socket(url.getHost(), url.getPort());
                strangers.add(stranger);
                stranger.getOutputStream().write("GET /x HTTP/1.1\r\nX-a: ".getBytes(StandardCharsets.US_ASCII));
                if (i % 50 == 49) {
                    assertThat(send(review.url(), "GET", "").statusCode()).isEqualTo(200);
                }
            }
        } finally {
            for (Socket stranger : strangers) {
                stranger.close();
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"GET mailto:x HTTP/1.1", "OPTIONS * HTTP/1.1", "GET  HTTP/1.1", "GET / HTTP/9.9", "\u0016\u0003\u0001", "GET",
        "POST / HTTP/1.1\r\nContent-Length: -5", "POST / HTTP/1.1\r\nTransfer-Encoding: chunked"})
    void requestThatIsNotUnderstood_isRefused(String head) throws Exception {
        URI url = URI.create(review.url());
        try (Socket client = new Socket(url.getHost(), url.getPort())) {
            client.getOutputStream().write((head + "\r\n\r\n").getBytes(StandardCharsets.ISO_8859_1));
            assertThat(new String(client.getInputStream().readAllBytes(), StandardCharsets.US_ASCII)).startsWith("HTTP/1.1 400 ");
        }
    }

    /** The head and the content of a request arrive in many parts. */
    @Test
    void slowChange_isReceived() throws Exception {
        URI url = URI.create(review.url());
        String request = "POST " + url.getPath() + "change HTTP/1.1\r\nHost: x\r\nContent-Length: " + CHANGE.length() + "\r\n\r\n" + CHANGE;
        try (Socket client = new Socket(url.getHost(), url.getPort())) {
            client.setTcpNoDelay(true);
            for (byte part : request.getBytes(StandardCharsets.US_ASCII)) {
                client.getOutputStream().write(part);
            }
            assertThat(new String(client.getInputStream().readAllBytes(), StandardCharsets.US_ASCII)).startsWith("HTTP/1.1 204 ");
        }
        assertThat(changes).hasSize(1);
    }
}
