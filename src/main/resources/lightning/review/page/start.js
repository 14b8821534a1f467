if (isLive) {
  byId("mode").hidden = false;
  connect();
} else {
  await fromFile();
}
