// catch_compat.hpp for the one file that listens to the tests, tests/tools/judged.cpp: version 2 or 3 of Catch2.
#pragma once
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_test_case_info.hpp>
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
using Listener = Catch::EventListenerBase;
/// The name of the test case that ended.
inline const std::string& name_of(const Catch::TestCaseStats& stats) {
  return stats.testInfo->name;
}
#else
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>
using Listener = Catch::TestEventListenerBase;
/// The name of the test case that ended.
inline const std::string& name_of(const Catch::TestCaseStats& stats) { return stats.testInfo.name; }
#endif
